#include "view/panel.hpp"

#include "view/panel_text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace clack::view {

namespace {

constexpr ImU32 bar_colour = IM_COL32(86, 180, 233, 160),
                exact_colour = IM_COL32(255, 255, 255, 255),
                maxwell_colour = IM_COL32(230, 159, 0, 255);

void curve(std::vector<float> const& values, float top, ImVec2 origin, ImVec2 size, ImU32 colour,
           float width) {
    std::vector<ImVec2> points;
    for (std::size_t k = 0; k < values.size(); ++k) {
        float const x = static_cast<float>(k) / static_cast<float>(values.size() - 1);
        points.emplace_back(origin.x + x * size.x, origin.y + size.y * (1 - values[k] / top));
    }
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()), colour,
                                            0, width);
}

void draw_histogram(SpeedHistogram const& speeds, float chart_height) {
    if (speeds.measured.empty()) {
        text("no ball moves");
        return;
    }
    ImVec2 const size(ImGui::GetContentRegionAvail().x, chart_height),
        origin = ImGui::GetCursorScreenPos();
    auto* const list = ImGui::GetWindowDrawList();
    bool const has_law = !speeds.maxwell.empty();
    auto const& highest = has_law ? speeds.maxwell : speeds.measured;
    float const top = (has_law ? 1.6f : 1.1f) * *std::max_element(highest.begin(), highest.end());
    auto const classes = static_cast<float>(speeds.measured.size());
    for (std::size_t k = 0; k < speeds.measured.size(); ++k) {
        float const left = origin.x + size.x * static_cast<float>(k) / classes;
        float const height = size.y * std::min(speeds.measured[k] / top, 1.f);
        list->AddRectFilled({left + 1, origin.y + size.y - height},
                            {left + size.x / classes, origin.y + size.y}, bar_colour);
    }
    if (has_law) curve(speeds.maxwell, top, origin, size, maxwell_colour, 3);
    if (!speeds.exact.empty()) curve(speeds.exact, top, origin, size, exact_colour, 1.3f);
    list->AddLine({origin.x, origin.y + size.y}, {origin.x + size.x, origin.y + size.y},
                  axis_colour);
    ImGui::Dummy(size);
    auto const end = fmt::format("{:.3g}", speeds.top);
    scale_ends("speed", speeds.beyond > 0 ? fmt::format("{}, {} beyond", end, speeds.beyond) : end);
    if (!speeds.exact.empty()) {
        ImGui::TextColored({1, 1, 1, 1}, "exact law");
        ImGui::SameLine();
    }
    if (has_law) {
        ImGui::TextColored({0.9f, 0.62f, 0, 1}, "Maxwell-Boltzmann");
        ImGui::SameLine();
    }
    ImGui::TextColored({0.34f, 0.71f, 0.91f, 1}, "balls now");
}

/// Whether the speeds are what they should be, or why nothing says how they should be.
void draw_judgement(Physics const& physics) {
    if (!physics.without_law.empty()) {
        ImGui::TextWrapped("%s", physics.without_law.c_str());
    } else if (physics.speed_test) {
        text(fmt::format("chi-square {:.1f} of {} d.o.f., p = {:.2g}",
                         physics.speed_test->chi_square, physics.speed_test->degrees_of_freedom,
                         physics.speed_test->p_value));
    } else {
        text("chi-square: too few balls");
    }
}

} // namespace

void scale_ends(std::string const& name, double top) {
    scale_ends(name, fmt::format("{:.3g}", top));
}

void scale_ends(std::string const& name, std::string const& top) {
    float const left = ImGui::GetCursorPosX(), width = ImGui::GetContentRegionAvail().x;
    auto const write = [&](std::string const& words, float share) {
        ImGui::SameLine(left + share * (width - ImGui::CalcTextSize(words.c_str()).x));
        text(words);
    };
    text("0");
    write(name, 0.5f);
    write(top, 1);
}

void draw_physics(Shown const& shown, float chart_height) {
    Physics const& physics = shown.physics;
    draw_histogram(physics.speeds, chart_height);
    draw_judgement(physics);
    ImGui::Separator();
    bool const is_gas = physics.directions == 3;
    if (is_gas) {
        draw_pressure(physics, shown.frame.system.boundary, chart_height);
        ImGui::Separator();
    }
    auto const& sample = shown.frame.sample;
    auto const& tallies = sample.tallies;
    text(fmt::format("{} {:.6g}, energy drift {:.2g}", is_gas ? "kT" : "kinetic energy",
                     is_gas ? physics.temperature : sample.kinetic_energy, physics.energy_drift));
    text(fmt::format("deepest overlap {:.2g} diameters", tallies.deepest_overlap));
    text(fmt::format("collisions {} + {} with walls", tallies.ball_collisions,
                     tallies.wall_collisions));
    text(shown.playing == Playing::yes
             ? fmt::format("{:.3g} a second, engine {:.1f} % of the time",
                           shown.rates.collisions_per_second, 100 * shown.rates.engine_share)
             : "engine at rest");
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("processor time of the engine alone over the time that passed;\n"
                          "copies for pictures, drawing and this panel are not in it");
    }
}

} // namespace clack::view
