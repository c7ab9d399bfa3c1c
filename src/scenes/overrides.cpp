#include "scenes/overrides.hpp"

#include "scenes/message.hpp"
#include "scenes/vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace clack {

namespace {

InputError refuse(std::string const& override_text, std::string const& rule) {
    return input_error(fmt::format("--set {}: {}", override_text, rule));
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Text that cannot be mistaken for a misspelt number, list or quotation.
bool is_word(std::string const& text) {
    return (std::isalpha(static_cast<unsigned char>(text.front())) ||
            std::string_view("._/~").find(text.front()) != std::string_view::npos) &&
           std::none_of(text.begin(), text.end(), is_control);
}

/// Puts the value of "value = ..." under `key`: as TOML where it is, else as a string.
void insert_value(toml::table& section, std::string const& key, std::string const& value,
                  std::string const& override_text) {
    if (value.empty() || std::any_of(value.begin(), value.end(), is_control))
        throw refuse(override_text, "has no value; write section.key=value on one line");
    try {
        toml::table parsed = toml::parse("value = " + value);
        section.insert_or_assign(key, std::move(*parsed.get("value")));
    } catch (toml::parse_error const&) {
        if (!is_word(value)) {
            throw refuse(override_text, "the value is neither TOML nor a word; write a number, "
                                        "true, false, a word, or a list in [ ]");
        }
        section.insert_or_assign(key, value);
    }
}

void remove_excluded(toml::table& section, std::string const& key) {
    for (auto const& group : exclusive_keys()) {
        if (std::find(group.begin(), group.end(), key) == group.end()) continue;
        for (auto const other : group)
            if (other != key) section.erase(other);
    }
}

} // namespace

std::string apply_override(toml::table& table, std::string const& override_text) {
    auto const equals = override_text.find('=');
    if (equals == std::string::npos)
        throw refuse(override_text, "must read section.key=value, as in run.seed=7");
    std::string path = override_text.substr(0, equals);
    auto const dot = path.find('.');
    std::string const section_name = dot == std::string::npos ? "" : path.substr(0, dot);
    std::string const key = dot == std::string::npos ? path : path.substr(dot + 1);

    auto const* const section = find_section(section_name);
    if (section == nullptr) {
        throw refuse(override_text, fmt::format("[{}] is not a section of a scene, which has "
                                                "container, balls, velocities, run, output",
                                                section_name));
    }
    if (!section->knows(key)) {
        throw refuse(override_text,
                     fmt::format("{} is not a key of {}, which takes {}", key,
                                 section_name.empty() ? "the scene" : "[" + section_name + "]",
                                 section->listed_keys()));
    }

    if (section_name.empty()) {
        insert_value(table, key, override_text.substr(equals + 1), override_text);
        return path;
    }
    toml::table* target = table[section_name].as_table();
    if (target == nullptr) {
        table.insert_or_assign(section_name, toml::table{});
        target = table[section_name].as_table();
    }
    remove_excluded(*target, key);
    insert_value(*target, key, override_text.substr(equals + 1), override_text);
    return path;
}

} // namespace clack
