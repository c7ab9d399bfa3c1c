#pragma once
// Every section and key that a scene file can hold.

#include "scenes/key.hpp"

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
    static std::vector<SectionVocabulary> const sections = [] {
        std::vector<SectionVocabulary> list;
        for (Key const known : {key::title,
                                key::boundary,
                                key::side,
                                key::packing_fraction,
                                key::count,
                                key::diameter,
                                key::mass,
                                key::arrangement,
                                key::positions,
                                key::start_path,
                                key::distribution,
                                key::temperature,
                                key::velocities,
                                key::velocity_path,
                                key::seed,
                                key::equilibrate,
                                key::collisions_per_ball,
                                key::time,
                                key::collisions,
                                key::method,
                                key::precision,
                                key::frame_interval,
                                key::events}) {
            if (list.empty() || list.back().name != known.section)
                list.push_back({known.section, {}});
            list.back().keys.push_back(known.name);
        }
        return list;
    }();
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
        {key::side.name, key::packing_fraction.name},
        {key::collisions_per_ball.name, key::time.name, key::collisions.name}};
    return groups;
}

} // namespace clack
