#pragma once
// A scene file as text with known sections and keys: remembers where each value came from, so that
// every mistake can be shown at its line.

#include "scenes/key.hpp"
#include "state/errors.hpp"

#include <Eigen/Core>
#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace clack {

/// The closed interval that a number must lie in, and what it stands for.
struct Range {
    double low, high;
    std::string_view meaning; // "a length", "collisions per ball"
};

/// A scene file after its overrides. Reading a key gives nothing where the key is absent, and
/// throws InputError, one line with value, rule and place, where its value breaks the rule.
class Document {
public:
    /// Each override is "section.key=value". Throws InputError when the text is not TOML, holds a
    /// section or key that no scene has, or an override cannot be written in.
    Document(std::string const& text, std::string source,
             std::vector<std::string> const& overrides);

    bool has(Key key) const { return find(key) != nullptr; }
    std::optional<std::string> string(Key key) const;
    std::optional<bool> flag(Key key) const;
    std::optional<double> number(Key key, Range const& range) const;
    std::optional<std::int64_t> whole_number(Key key, std::int64_t low, std::int64_t high) const;
    /// A list of lists of three finite numbers of at most `largest`, one column each.
    std::optional<Eigen::Matrix3Xd> vectors(Key key, double largest) const;

    /// One of a few words, each with what it stands for.
    template <class Value>
    std::optional<Value>
    choice(Key key, std::initializer_list<std::pair<std::string_view, Value>> choices) const {
        auto const word = string(key);
        if (!word) return std::nullopt;
        std::string words;
        for (auto const& [name, value] : choices) {
            if (name == *word) return value;
            words.append(words.empty() ? "" : ", ").append(name);
        }
        throw mistake(key, "must be one of " + words);
    }

    /// `name = value: rule (file:line)`, with the override in place of file:line where the value
    /// came from one.
    InputError mistake(Key key, std::string const& rule) const;
    /// `message (file:line)` with the line of one element of a list.
    InputError mistake_in_list(Key key, std::size_t index, std::string const& message) const;
    /// `name is missing from [section]: advice (file)`.
    InputError missing(Key key, std::string const& advice) const;

    /// The text that holds the scene as it is read: the file's own without overrides.
    std::string const& text() const { return text_; }

private:
    toml::node const* find(Key key) const;
    void check_names() const;
    void check_section(std::string_view section, toml::key const& key,
                       toml::node const& node) const;
    std::string place(Key key, toml::node const* node) const;
    InputError mistake_at(Key key, std::string const& name_and_value, toml::node const& node,
                          std::string const& rule) const;
    Eigen::Vector3d vector(Key key, std::size_t index, toml::node const& node,
                           double largest) const;

    std::string source_, text_;
    toml::table table_;
    std::map<std::string, std::string, std::less<>> origins_; // "section.key" -> its override
};

} // namespace clack
