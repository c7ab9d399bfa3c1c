#include "view/panel.hpp"

#include "view/panel_text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace clack::view {

namespace {

ImVec4 const warning_colour(1, 0.65f, 0.2f, 1);

/// Writes at the right end of the line.
void at_right(std::string const& words, ImVec4 const& colour) {
    ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x -
                    ImGui::CalcTextSize(words.c_str()).x);
    text(words, colour);
}

void draw_clock(Session& session) {
    Shown const& shown = *session.shown;
    ImGui::TextWrapped("%s", session.title.c_str());
    text(fmt::format("time {:.6g}", shown.frame.snapshot.time));
    auto const plain = ImGui::GetStyle().Colors[ImGuiCol_Text];
    if (shown.equilibration < 1) {
        at_right(fmt::format("equilibrating: {:.0f} %", 100 * shown.equilibration), warning_colour);
    } else if (shown.playing == Playing::no) {
        at_right("paused", plain);
    } else {
        bool const slow = shown.rates.speed < 0.9 * shown.speed;
        at_right(fmt::format("in truth {:.3g} a second", shown.rates.speed),
                 slow ? warning_colour : plain);
    }
}

void draw_playback(Session& session) {
    Shown const& shown = *session.shown;
    draw_clock(session);
    if (ImGui::Button(shown.playing == Playing::yes ? "pause" : "play ")) session.toggle_playing();
    ImGui::SameLine();
    std::string const step = shown.frame.pasts.empty() ? "frame" : "collision";
    if (ImGui::Button(("< " + step).c_str())) session.player.step_back();
    ImGui::SameLine();
    if (ImGui::Button((step + " >").c_str())) session.player.step();
    auto exponent = static_cast<float>(std::log10(shown.speed));
    ImGui::SetNextItemWidth(-70);
    auto const label = fmt::format("{:.3g} a second", shown.speed);
    if (ImGui::SliderFloat("speed", &exponent, -3, 3, label.c_str()))
        session.player.set_speed(std::pow(10.0, static_cast<double>(exponent)));
    if (std::isfinite(shown.last_time)) {
        auto time = static_cast<float>(shown.frame.snapshot.time);
        ImGui::SetNextItemWidth(-70);
        if (ImGui::SliderFloat("time", &time, static_cast<float>(shown.first_time),
                               static_cast<float>(shown.last_time), "%.4g"))
            session.player.seek(static_cast<double>(time));
    }
    if (!shown.remark.empty()) ImGui::TextWrapped("%s", shown.remark.c_str());
    if (!shown.message.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1, 0.5f, 0.4f, 1));
        ImGui::TextWrapped("%s", shown.message.c_str());
        ImGui::PopStyleColor();
    }
}

constexpr std::array<char const*, 4> colouring_names{"speed", "kinetic energy",
                                                     "number of collisions", "side at the start"};

char const* colouring_name(Colouring colouring) {
    return colouring_names[static_cast<std::size_t>(colouring)];
}

void draw_sides() {
    constexpr float line_height = 13; // [pixels]
    for (auto const& [name, colour] :
         {std::pair("left", left_colour), std::pair("right at the start", right_colour)}) {
        ImGui::ColorButton(name, on_screen(colour), ImGuiColorEditFlags_NoTooltip,
                           {line_height, line_height});
        ImGui::SameLine();
        text(name);
        ImGui::SameLine();
    }
    ImGui::NewLine();
}

void draw_legend(Session const& session) {
    auto const colouring = session.look.colouring;
    if (colouring == Colouring::side) {
        draw_sides();
        return;
    }
    if (colouring == Colouring::collisions && session.shown->frame.pasts.empty()) {
        text("grey: " + session.shown->unforetold);
        return;
    }
    ImVec2 const origin = ImGui::GetCursorScreenPos();
    float const width = ImGui::GetContentRegionAvail().x;
    constexpr int steps = 40;
    for (int k = 0; k < steps; ++k) {
        auto const colour = scale_colour((k + 0.5) / steps);
        float const left = origin.x + width * static_cast<float>(k) / steps;
        ImGui::GetWindowDrawList()->AddRectFilled({left, origin.y},
                                                  {left + width / steps + 1, origin.y + 8},
                                                  IM_COL32(colour[0], colour[1], colour[2], 255));
    }
    ImGui::Dummy({width, 8});
    bool const ends = colouring == Colouring::collisions; // no ball is beyond the scale
    scale_ends(colouring_name(colouring),
               fmt::format("{:.3g}{}", scale_top(session.shown->frame, colouring),
                           ends ? "" : " and more"));
}

void checkbox(char const* label, Visible& what) {
    bool on = what == Visible::yes;
    if (ImGui::Checkbox(label, &on)) what = on ? Visible::yes : Visible::no;
}

void draw_cut(Cut& cut) {
    constexpr std::array<char const*, 6> faces{"left, x = 0", "right, x = 1",  "front, y = 0",
                                               "back, y = 1", "bottom, z = 0", "top, z = 1"};
    auto share = static_cast<float>(cut.share);
    ImGui::SetNextItemWidth(110);
    if (ImGui::SliderFloat("##share", &share, 0, 1, cut.is_whole() ? "whole" : "%.2f is left"))
        cut.share = static_cast<double>(share);
    ImGui::SameLine();
    auto from = static_cast<int>(cut.from);
    ImGui::SetNextItemWidth(-70);
    if (ImGui::Combo("cut at", &from, faces.data(), static_cast<int>(faces.size())))
        cut.from = static_cast<Face>(from);
}

/// In the colour of the rings around the two.
void draw_next(Shown const& shown) {
    if (!shown.unforetold.empty()) text("next pair " + shown.unforetold, on_screen(pair_colour));
    auto const& next = shown.frame.next;
    if (!next) return;
    auto const other = next->second >= 0 ? std::to_string(next->second) : std::string("a wall");
    text(fmt::format("next: {} and {} at {:.8g}", next->first, other, next->time),
         on_screen(pair_colour));
}

void draw_look(Session& session) {
    auto colouring = static_cast<int>(session.look.colouring);
    ImGui::SetNextItemWidth(-70);
    if (ImGui::Combo("colour", &colouring, colouring_names.data(),
                     static_cast<int>(colouring_names.size())))
        session.look.colouring = static_cast<Colouring>(colouring);
    draw_legend(session);
    checkbox("flash when hit", session.look.flashes);
    ImGui::SameLine();
    checkbox("next pair", session.look.next_pair);
    ImGui::SameLine();
    checkbox("cube", session.look.cube);
    draw_cut(session.look.cut);
    if (session.look.next_pair == Visible::yes) draw_next(*session.shown);
}

void draw_ball(Session& session) {
    Frame const& frame = session.shown->frame;
    if (frame.traced < 0) {
        text("click a ball to follow it");
        return;
    }
    auto const ball = static_cast<std::size_t>(frame.traced);
    auto const collisions = frame.pasts.empty()
                                ? std::string()
                                : fmt::format(", {} collisions", frame.pasts[ball].collisions);
    text(fmt::format("ball {}: speed {:.6g}{}", frame.traced,
                     frame.snapshot.velocities.col(frame.traced).norm(), collisions));
    if (ImGui::Button("let go")) session.player.trace(-1);
    if (auto const& why = session.shown->unforetold; !why.empty()) {
        ImGui::SameLine();
        text("next " + why, on_screen(partner_colour));
    }
    auto const& next = frame.next_of_traced;
    if (!next) return;
    auto const other = next->first == frame.traced ? next->second : next->first;
    ImGui::SameLine();
    double const wait = next->time - frame.snapshot.time;
    if (other < 0)
        text(fmt::format("next a wall, in {:.4g}", wait));
    else
        text(fmt::format("next ball {}, in {:.4g}", other, wait), on_screen(partner_colour));
}

void draw_choice(Session& session) {
    auto& choice = session.choice;
    constexpr float width = 72, second_column = 150; // [pixels]
    ImGui::SetNextItemWidth(width);
    ImGui::InputInt("balls", &choice.count, 0);
    ImGui::SameLine(second_column);
    ImGui::SetNextItemWidth(width);
    ImGui::InputFloat("packing", &choice.packing_fraction, 0, 0, "%.4f");
    ImGui::SetNextItemWidth(width);
    ImGui::InputInt("seed", &choice.seed, 0);
    constexpr std::array<char const*, 4> methods{"auto", "table", "heap", "fast"};
    ImGui::SameLine(second_column);
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("method", choice.method.c_str())) {
        for (char const* const method : methods) {
            if (ImGui::Selectable(method, choice.method == method)) choice.method = method;
        }
        ImGui::EndCombo();
    }
    if (ImGui::Button("start again")) session.restart();
    ImGui::SameLine();
    if (ImGui::Button("with another seed")) session.restart_with_another_seed();
}

void draw_scene(Session& session) {
    System const& system = session.shown->frame.system;
    ImGui::TextWrapped("%s", session.shown->description.c_str());
    if (session.options.form == Form::scene) {
        draw_choice(session);
    } else {
        text(fmt::format("{} balls, packing fraction {:.4g}", system.count,
                         system.packing_fraction()));
    }
}

void draw_help(Session& session) {
    if (!session.help) return;
    ImGui::SetNextWindowPos({30, 30}, ImGuiCond_Appearing);
    if (ImGui::Begin("keys", &session.help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings)) {
        for (Key const& key : keys()) text(fmt::format("{:<12}{}", key.name, key.effect));
        ImGui::Separator();
        text("drag        turn");
        text("right drag  move");
        text("wheel       zoom");
        text("click       follow a ball");
    }
    ImGui::End();
}

} // namespace

void draw_panel(Session& session, DrawingReport const& report) {
    draw_help(session);
    if (!session.panel) return;
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x - panel_width, 0});
    ImGui::SetNextWindowSize({panel_width, size.y});
    ImGui::SetNextWindowBgAlpha(1); // no picture lies behind it, but panels of before
    ImGui::Begin("clack", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    draw_playback(session);
    float& chart_height = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("charts"), 90);
    constexpr auto open = ImGuiTreeNodeFlags_DefaultOpen;
    if (ImGui::CollapsingHeader("physics", open)) draw_physics(*session.shown, chart_height);
    if (ImGui::CollapsingHeader("picture", open)) draw_look(session);
    if (ImGui::CollapsingHeader("ball", open)) draw_ball(session);
    if (ImGui::CollapsingHeader("scene", open)) draw_scene(session);
    ImGui::Separator();
    text(fmt::format("{} {} drawn in {:.0f} ms; ? for the keys", report.balls_drawn,
                     report.balls_drawn == 1 ? "ball" : "balls", 1000 * report.seconds));
    // The two charts share what room is left, next time.
    float const spare =
        size.y - ImGui::GetStyle().WindowPadding.y - ImGui::GetCursorPosY() - ImGui::GetScrollY();
    constexpr float lowest = 34, highest = 120;
    chart_height = std::clamp(std::floor(chart_height + spare / 2), lowest, highest);
    ImGui::End();
}

} // namespace clack::view
