#include "scenes/document.hpp"

#include "scenes/message.hpp"
#include "scenes/overrides.hpp"
#include "scenes/vocabulary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace clack {

namespace {

constexpr std::size_t shown_length = 40; // longer values are cut, to keep a message on its line

std::string cut(std::string text) {
    if (text.size() <= shown_length) return text;
    std::size_t end = shown_length;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80)
        --end; // whole letters
    return text.substr(0, end) + "...";
}

/// Integers are taken where a real number is wanted.
std::optional<double> real_value(toml::node const& node) {
    if (auto const* const number = node.as_floating_point()) return number->get();
    if (auto const* const number = node.as_integer()) return static_cast<double>(number->get());
    return std::nullopt;
}

/// A value as a message shows it.
std::string shown(toml::node const& node) {
    if (node.is_array()) return "[...]";
    if (node.is_table()) return "{...}";
    if (auto const* const text = node.as_string()) return cut("\"" + text->get() + "\"");
    if (auto const* const number = node.as_floating_point()) {
        auto const digits = fmt::format("{}", number->get());
        // 100.0 is not the whole number 100.
        return digits.find_first_not_of("-0123456789") == std::string::npos ? digits + ".0"
                                                                            : digits;
    }
    if (auto const* const number = node.as_integer()) return fmt::format("{}", number->get());
    if (auto const* const flag = node.as_boolean()) return flag->get() ? "true" : "false";
    return "a date or time";
}

/// The parser follows dotted names by recursion: a name of very many parts would use up its stack.
void check_depth(std::string const& text, std::string const& source) {
    constexpr int most_parts = 1000;
    int parts = 0;
    std::size_t line = 1;
    for (char const c : text) {
        if (c == '\n') ++line;
        if (c == '.') ++parts;
        if (std::string_view("\n,=[]{}").find(c) != std::string_view::npos) parts = 0;
        if (parts > most_parts) {
            throw input_error(fmt::format("not TOML: a name of more than {} parts ({}:{})",
                                          most_parts, source, line));
        }
    }
}

std::string dotted(Key key) {
    return key.section.empty() ? std::string(key.name)
                               : fmt::format("{}.{}", key.section, key.name);
}

std::string section_title(std::string_view section) {
    return section.empty() ? "the top of the scene" : fmt::format("[{}]", section);
}

} // namespace

Document::Document(std::string const& text, std::string source,
                   std::vector<std::string> const& overrides)
    : source_(std::move(source)), text_(text) {
    check_depth(text, source_);
    try {
        table_ = toml::parse(text);
    } catch (toml::parse_error const& error) {
        throw input_error(fmt::format("not TOML: {} ({}:{})", error.description(), source_,
                                      error.source().begin.line));
    }
    check_names();
    if (overrides.empty()) return;
    for (auto const& override_text : overrides)
        origins_[apply_override(table_, override_text)] = override_text;
    std::ostringstream written;
    written << table_ << '\n';
    text_ = written.str();
}

void Document::check_names() const {
    for (auto const& [key, node] : table_) {
        auto const* const section = find_section(key.str());
        if (section != nullptr && !section->name.empty()) {
            check_section(section->name, key, node);
        } else if (!find_section("")->knows(key.str())) {
            auto const name = key.str().empty() ? "\"\"" : cut(std::string(key.str()));
            throw input_error(fmt::format(
                "{}: not a section or key of a scene, which has title, [container], [balls], "
                "[velocities], [run], [output]; correct or remove it ({}:{})",
                node.is_table() ? "[" + name + "]" : name, source_, key.source().begin.line));
        }
    }
}

void Document::check_section(std::string_view section, toml::key const& key,
                             toml::node const& node) const {
    auto const* const table = node.as_table();
    if (table == nullptr) {
        throw input_error(fmt::format("{} = {}: must be a section; write [{}] on a line of its "
                                      "own ({}:{})",
                                      section, shown(node), section, source_,
                                      key.source().begin.line));
    }
    auto const* const vocabulary = find_section(section);
    for (auto const& [name, value] : *table) {
        if (!vocabulary->knows(name.str())) {
            throw input_error(fmt::format(
                "{} = {}: not a key of [{}], which takes {}; correct or remove it ({}:{})",
                cut(std::string(name.str())), shown(value), section, vocabulary->listed_keys(),
                source_, name.source().begin.line));
        }
    }
}

toml::node const* Document::find(Key key) const {
    auto const* const section = key.section.empty() ? &table_ : table_[key.section].as_table();
    return section == nullptr ? nullptr : section->get(key.name);
}

std::string Document::place(Key key, toml::node const* node) const {
    if (auto const origin = origins_.find(dotted(key)); origin != origins_.end())
        return "--set " + cut(origin->second);
    return node == nullptr ? source_ : fmt::format("{}:{}", source_, node->source().begin.line);
}

InputError Document::mistake_at(Key key, std::string const& name_and_value, toml::node const& node,
                                std::string const& rule) const {
    return input_error(fmt::format("{}: {} ({})", name_and_value, rule, place(key, &node)));
}

InputError Document::mistake(Key key, std::string const& rule) const {
    auto const* const node = find(key);
    if (node == nullptr) return missing(key, rule);
    return mistake_at(key, fmt::format("{} = {}", key.name, shown(*node)), *node, rule);
}

InputError Document::mistake_in_list(Key key, std::size_t index, std::string const& message) const {
    return input_error(
        fmt::format("{} ({})", message, place(key, find(key)->as_array()->get(index))));
}

InputError Document::missing(Key key, std::string const& advice) const {
    if (!key.section.empty() && table_.get(key.section) == nullptr) {
        return input_error(fmt::format("[{}] is missing: a scene needs [container], [balls], "
                                       "[velocities] and [run]; add it ({})",
                                       key.section, source_));
    }
    return input_error(fmt::format("{} is missing from {}: {} ({})", key.name,
                                   section_title(key.section), advice, source_));
}

std::optional<std::string> Document::string(Key key) const {
    auto const* const node = find(key);
    if (node == nullptr) return std::nullopt;
    if (!node->is_string()) throw mistake(key, "must be text in quotes");
    return node->as_string()->get();
}

std::optional<bool> Document::flag(Key key) const {
    auto const* const node = find(key);
    if (node == nullptr) return std::nullopt;
    if (!node->is_boolean()) throw mistake(key, "must be true or false, without quotes");
    return node->as_boolean()->get();
}

std::optional<double> Document::number(Key key, Range const& range) const {
    auto const* const node = find(key);
    if (node == nullptr) return std::nullopt;
    auto const value = real_value(*node);
    if (!value) throw mistake(key, fmt::format("must be a number, {}", range.meaning));
    if (!std::isfinite(*value))
        throw mistake(key, fmt::format("must be a finite number, {}", range.meaning));
    if (*value < range.low || *value > range.high) {
        throw mistake(key, fmt::format("must lie in [{:.4g}, {:.4g}], {}", range.low, range.high,
                                       range.meaning));
    }
    return value;
}

std::optional<std::int64_t> Document::whole_number(Key key, std::int64_t low,
                                                   std::int64_t high) const {
    auto const* const node = find(key);
    if (node == nullptr) return std::nullopt;
    auto const* const integer = node->as_integer();
    if (integer == nullptr || integer->get() < low || integer->get() > high) {
        throw mistake(key, fmt::format("must be a whole number from {} to {}, written in digits "
                                       "only",
                                       low, high));
    }
    return integer->get();
}

std::optional<Eigen::Matrix3Xd> Document::vectors(Key key, double largest) const {
    auto const* const node = find(key);
    if (node == nullptr) return std::nullopt;
    auto const* const list = node->as_array();
    if (list == nullptr) throw mistake(key, "must be a list with [x, y, z] for each ball");
    Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(list->size()));
    for (std::size_t i = 0; i < list->size(); ++i)
        columns.col(static_cast<Eigen::Index>(i)) = vector(key, i, *list->get(i), largest);
    return columns;
}

Eigen::Vector3d Document::vector(Key key, std::size_t index, toml::node const& node,
                                 double largest) const {
    auto const name = fmt::format("{}[{}]", key.name, index);
    auto const* const list = node.as_array();
    if (list == nullptr) {
        throw mistake_at(key, fmt::format("{} = {}", name, shown(node)), node,
                         "must be a list of three numbers, [x, y, z]");
    }
    if (list->size() != 3) {
        throw mistake_at(
            key, name, node,
            fmt::format("must be a list of three numbers, [x, y, z], and has {}", list->size()));
    }
    Eigen::Vector3d column;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto const& element = *list->get(axis);
        auto const value = real_value(element);
        if (!value || !(std::abs(*value) <= largest)) { // false for NaN too
            throw mistake_at(key, fmt::format("{}[{}] = {}", name, axis, shown(element)), element,
                             fmt::format("must be a finite number of size at most {:.4g}; ball {} "
                                         "needs one",
                                         largest, index));
        }
        column[static_cast<Eigen::Index>(axis)] = *value;
    }
    return column;
}

} // namespace clack
