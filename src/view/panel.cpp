#include "view/panel.hpp"

#include "view/panel_text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace clack::view {

namespace {

void draw_clock(Session& session) {
    Shown const& shown = *session.shown;
    text(fmt::format("time {:.6g}", shown.frame.snapshot.time));
    if (shown.equilibration < 1) {
        text(fmt::format("equilibrating: {:.0f} %", 100 * shown.equilibration));
    } else if (shown.playing == Playing::no) {
        text(fmt::format("paused; speed {:.3g}", shown.speed));
    } else {
        bool const slow = shown.rates.speed < 0.9 * shown.speed;
        ImGui::TextColored(slow ? ImVec4(1, 0.65f, 0.2f, 1)
                                : ImGui::GetStyle().Colors[ImGuiCol_Text],
                           "speed %.3g, in truth %.3g", shown.speed, shown.rates.speed);
    }
}

void draw_playback(Session& session) {
    Shown const& shown = *session.shown;
    draw_clock(session);
    if (ImGui::Button(shown.playing == Playing::yes ? "pause" : "play ")) session.toggle_playing();
    ImGui::SameLine();
    if (ImGui::Button("< collision")) session.player.step_back();
    ImGui::SameLine();
    if (ImGui::Button("collision >")) session.player.step();
    auto exponent = static_cast<float>(std::log10(shown.speed));
    ImGui::SetNextItemWidth(-70);
    auto const label = fmt::format("{:.3g} x", shown.speed);
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

void draw_legend(Session const& session) {
    if (session.look.colouring == Colouring::side) {
        text("blue and orange: left and right at the start");
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
    scale_ends(fmt::format("{:.3g}", scale_top(session.shown->frame, session.look.colouring)));
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

void draw_look(Session& session) {
    constexpr std::array<char const*, 4> names{"speed", "kinetic energy", "number of collisions",
                                               "side at the start"};
    auto colouring = static_cast<int>(session.look.colouring);
    ImGui::SetNextItemWidth(-70);
    if (ImGui::Combo("colour", &colouring, names.data(), static_cast<int>(names.size())))
        session.look.colouring = static_cast<Colouring>(colouring);
    draw_legend(session);
    checkbox("flashes", session.look.flashes);
    ImGui::SameLine();
    checkbox("next pair", session.look.next_pair);
    ImGui::SameLine();
    checkbox("cube", session.look.cube);
    draw_cut(session.look.cut);
    if (auto const& next = session.shown->frame.next;
        next && session.look.next_pair == Visible::yes) {
        text(next->second >= 0
                 ? fmt::format("next: {} and {} at {:.8g}", next->first, next->second, next->time)
                 : fmt::format("next: {} and a wall at {:.8g}", next->first, next->time));
    }
}

void draw_ball(Session& session) {
    Frame const& frame = session.shown->frame;
    if (frame.traced < 0) {
        text("click a ball to follow it");
        return;
    }
    auto const ball = static_cast<Eigen::Index>(frame.traced);
    text(fmt::format("ball {}: speed {:.6g}", frame.traced,
                     frame.snapshot.velocities.col(ball).norm()));
    text(fmt::format("{} collisions", frame.collisions[static_cast<std::size_t>(frame.traced)]));
    if (auto const& next = frame.next_of_traced) {
        auto const other = next->first == frame.traced ? next->second : next->first;
        text(other < 0
                 ? fmt::format("next a wall, in {:.4g}", next->time - frame.snapshot.time)
                 : fmt::format("next ball {}, in {:.4g}", other, next->time - frame.snapshot.time));
    }
    if (ImGui::Button("let go")) session.player.trace(-1);
}

void draw_scene(Session& session) {
    System const& system = session.shown->frame.system;
    text(fmt::format("{} balls, packing fraction {:.4g}", system.count, system.packing_fraction()));
    ImGui::TextWrapped("%s", session.shown->description.c_str());
    if (session.options.form != Form::scene) return;
    auto& choice = session.choice;
    ImGui::SetNextItemWidth(-130);
    ImGui::InputInt("balls", &choice.count, 0);
    ImGui::SetNextItemWidth(-130);
    ImGui::InputFloat("packing fraction", &choice.packing_fraction, 0, 0, "%.4f");
    ImGui::SetNextItemWidth(-130);
    ImGui::InputInt("seed", &choice.seed, 1);
    constexpr std::array<char const*, 4> methods{"auto", "table", "heap", "fast"};
    ImGui::SetNextItemWidth(-130);
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

void draw_help(Session& session) {
    if (!session.help) return;
    ImGui::SetNextWindowPos({30, 30}, ImGuiCond_Appearing);
    if (ImGui::Begin("keys", &session.help,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings)) {
        for (Key const& key : keys()) text(fmt::format("{:<8}{}", key.name, key.effect));
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
    ImGui::Begin("clack", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    draw_playback(session);
    constexpr auto open = ImGuiTreeNodeFlags_DefaultOpen;
    if (ImGui::CollapsingHeader("physics", open)) draw_physics(*session.shown);
    if (ImGui::CollapsingHeader("picture", open)) draw_look(session);
    if (ImGui::CollapsingHeader("ball", open)) draw_ball(session);
    if (ImGui::CollapsingHeader("scene", open)) draw_scene(session);
    ImGui::Separator();
    text(fmt::format("{} balls drawn in {:.0f} ms; ? for the keys", report.balls_drawn,
                     1000 * report.seconds));
    ImGui::End();
}

} // namespace clack::view
