#pragma once
// Every section and key that a scene file can hold.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace clack {

struct SectionVocabulary {
    std::string_view name; // empty: the top of the file
    std::vector<std::string_view> keys;

    bool knows(std::string_view key) const {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    }
    std::string listed_keys() const {
        std::string list;
        for (auto const key : keys) list.append(list.empty() ? "" : ", ").append(key);
        return list;
    }
};

inline std::vector<SectionVocabulary> const& scene_vocabulary() {
    static std::vector<SectionVocabulary> const sections{
        {"", {"title"}},
        {"container", {"boundary", "side", "packing_fraction"}},
        {"balls", {"count", "diameter", "mass", "arrangement", "positions", "path"}},
        {"velocities", {"distribution", "temperature", "velocities", "path"}},
        {"run",
         {"seed", "equilibrate", "collisions_per_ball", "time", "collisions", "method",
          "precision"}},
        {"output", {"frame_interval", "events"}}};
    return sections;
}

/// The section of that name, or nothing.
inline SectionVocabulary const* find_section(std::string_view name) {
    for (auto const& section : scene_vocabulary())
        if (section.name == name) return &section;
    return nullptr;
}

/// Keys of one section of which a scene has exactly one: naming one takes the others' place.
inline std::vector<std::vector<std::string_view>> const& exclusive_keys() {
    static std::vector<std::vector<std::string_view>> const groups{
        {"side", "packing_fraction"}, {"collisions_per_ball", "time", "collisions"}};
    return groups;
}

} // namespace clack
