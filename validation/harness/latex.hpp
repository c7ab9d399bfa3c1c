#pragma once
// Numbers and tables for the report, so that none is typed by hand.

#include "validation/harness/interval.hpp"

#include <string>
#include <utility>
#include <vector>

namespace clack::validation {

/// A value with its standard error in its last digits: 3.2694(12). The error keeps two digits; an
/// error of 0 leaves six digits and no bracket.
std::string with_error(Estimate const& estimate);

/// With so many significant digits; beyond 1e4 or below 1e-3 as a power of ten, in math mode:
/// $1.3 \times 10^{-5}$.
std::string significant(double value, int digits);

/// Plain text as TeX takes it: the characters that mean something there are escaped, and those that
/// its text fonts lack are set as mathematics.
std::string in_tex(std::string const& text);

/// \newcommand macros, one a number that the report quotes.
class Macros {
public:
    ///   prefix   the experiment's name in CamelCase; every macro starts with it
    explicit Macros(std::string prefix) : prefix_(std::move(prefix)) {}

    /// Defines \<prefix><name>. Throws std::invalid_argument unless prefix and name are letters
    /// only, as TeX wants them, and the name is new.
    void define(std::string const& name, std::string const& text);

    std::string text(std::vector<std::string> const& header) const;

private:
    std::string prefix_;
    std::vector<std::pair<std::string, std::string>> macros_;
};

/// A booktabs tabular.
///   alignment   TeX's column specification, such as "rrl"
///   head        column titles
std::string tabular(std::string const& alignment, std::vector<std::string> const& head,
                    std::vector<std::vector<std::string>> const& rows);

} // namespace clack::validation
