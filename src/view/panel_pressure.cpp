#include "view/panel.hpp"

#include "view/panel_text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace clack::view {

namespace {

ImVec4 const virial_colour(0.34f, 0.71f, 0.91f, 1), wall_colour(0.9f, 0.62f, 0, 1),
    theory_colour(1, 1, 1, 1);

constexpr float label_width = 50; // [pixels]

ImU32 faint(ImVec4 colour) {
    colour.w = 0.35f;
    return ImGui::ColorConvertFloat4ToU32(colour);
}

std::string with_error(std::optional<Estimate> const& estimate) {
    if (!estimate) return "no collision yet";
    if (!estimate->error) return fmt::format("{:.4g} (+- after longer)", estimate->value);
    return fmt::format("{:.5g} +- {:.2g}", estimate->value, *estimate->error);
}

void line_of(std::string const& label, std::optional<Estimate> const& estimate, ImVec4 colour) {
    text(label + with_error(estimate), colour);
}

/// The part of the window that the chart has, and what it spans.
struct Chart {
    ImVec2 origin, size; // [pixels]
    double end;          // of the time
    Range range;         // of Z

    ImVec2 at(double time, double z) const {
        auto const across = static_cast<float>(time / end);
        auto const up = static_cast<float>((z - range.low) / (range.high - range.low));
        return {origin.x + size.x * across, origin.y + size.y * (1 - up)};
    }
};

/// A line through the means, and a band of one standard error about it.
template <class Choose>
void draw_course(Chart const& chart, std::vector<PressurePoint> const& course, ImVec4 colour,
                 Choose const& choose) {
    auto* const list = ImGui::GetWindowDrawList();
    for (std::size_t k = 0; k + 1 < course.size(); ++k) {
        auto const& first = choose(course[k]);
        auto const& second = choose(course[k + 1]);
        if (!first || !second) continue;
        double const t1 = course[k].time, t2 = course[k + 1].time;
        if (first->error && second->error) {
            list->AddQuadFilled(chart.at(t1, first->value - *first->error),
                                chart.at(t1, first->value + *first->error),
                                chart.at(t2, second->value + *second->error),
                                chart.at(t2, second->value - *second->error), faint(colour));
        }
        list->AddLine(chart.at(t1, first->value), chart.at(t2, second->value),
                      ImGui::ColorConvertFloat4ToU32(colour), 1.5f);
    }
}

void draw_theory(Chart const& chart, Estimate const& theory) {
    auto* const list = ImGui::GetWindowDrawList();
    double const error = theory.error.value_or(0);
    list->AddRectFilled(chart.at(0, theory.value + error),
                        chart.at(chart.end, theory.value - error), faint(theory_colour));
    list->AddLine(chart.at(0, theory.value), chart.at(chart.end, theory.value),
                  ImGui::ColorConvertFloat4ToU32(theory_colour), 1);
}

/// Numbers left of the chart and below it.
void draw_axes(Chart const& chart) {
    ImVec2 const corner(chart.origin.x + chart.size.x, chart.origin.y + chart.size.y);
    auto* const list = ImGui::GetWindowDrawList();
    list->AddRect(chart.origin, corner, axis_colour);
    auto const write = [&](std::string const& words, float y) {
        ImVec2 const size = ImGui::CalcTextSize(words.c_str());
        list->AddText({chart.origin.x - size.x - 4, y - size.y / 2},
                      ImGui::GetColorU32(ImGuiCol_Text), words.c_str());
    };
    float const half_line = ImGui::GetFontSize() / 2;
    write(fmt::format("{:.4g}", chart.range.high), chart.origin.y + half_line);
    write("Z", chart.origin.y + chart.size.y / 2);
    write(fmt::format("{:.4g}", chart.range.low), corner.y - half_line);
    ImGui::Dummy({chart.size.x, chart.size.y});
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + label_width);
    scale_ends("time", chart.end);
}

void draw_chart(Physics const& physics, float height) {
    auto const& course = physics.course;
    if (course.size() < 2) return;
    ImVec2 const origin = ImGui::GetCursorScreenPos();
    Chart const chart{{origin.x + label_width, origin.y},
                      {ImGui::GetContentRegionAvail().x - label_width, height},
                      course.back().time,
                      range_of(physics)};
    auto* const list = ImGui::GetWindowDrawList();
    list->PushClipRect(chart.origin, {chart.origin.x + chart.size.x, chart.origin.y + chart.size.y},
                       true);
    if (physics.theory) draw_theory(chart, *physics.theory);
    draw_course(
        chart, course, virial_colour,
        [](PressurePoint const& point) -> auto const& { return point.factor.virial; });
    draw_course(
        chart, course, wall_colour,
        [](PressurePoint const& point) -> auto const& { return point.factor.wall; });
    list->PopClipRect();
    draw_axes(chart);
}

} // namespace

void draw_pressure(Physics const& physics, Boundary boundary, float chart_height) {
    draw_chart(physics, chart_height);
    auto const& factor = physics.compressibility_factor;
    line_of("Z by virial  ", factor.virial, virial_colour);
    if (boundary == Boundary::walls) line_of("Z by walls   ", factor.wall, wall_colour);
    if (physics.theory) {
        line_of("Z of theory  ", physics.theory, theory_colour);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("the fluid's equation of state, for so many balls in this cube");
    } else {
        text("Z of theory  none: few balls, or no fluid");
    }
}

} // namespace clack::view
