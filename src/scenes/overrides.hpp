#pragma once
// Overrides from the command line: "run.seed=7" written into a scene.

#include <toml++/toml.h>

#include <string>

namespace clack {

/// Writes "section.key=value" into the table and returns "section.key". The value is TOML, or a
/// word that is taken as a string. A key that excludes others (side and packing_fraction, the three
/// goals) takes their place. Throws InputError when there is no such key or no such value.
std::string apply_override(toml::table& table, std::string const& override_text);

} // namespace clack
