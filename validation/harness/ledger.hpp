#pragma once
// The account of an experiment that asks for many numbers: each quantity at each state point beside
// its reference, all judged together, printed, and left behind for figures, tables and the report.

#include "validation/harness/experiment.hpp"

#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

namespace clack::validation {

/// What is measured, or what tells state points apart.
struct Quantity {
    std::string name;   // in the data, with its unit if it has one
    std::string symbol; // in the report's tables, TeX
};
using Key = Quantity;

/// One line of the account. What a kind does not have is not a number.
struct Entry : Judgement {
    enum class Kind { compared, guide, fit, bound } kind;
    std::vector<std::string> state;
    Quantity quantity;
    Comparison comparison = {};
    double p_value = std::numeric_limits<double>::quiet_NaN(); // of a fit

    std::string word() const { return kind == Kind::guide ? "guide" : name_of(verdict); }
};

class Ledger {
public:
    explicit Ledger(std::initializer_list<Key> keys) : keys_(keys) {}

    /// A number that is judged. The comparison needs no name. `state` has a cell for each key.
    void compare(std::vector<std::string> state, Quantity quantity, Comparison comparison);
    /// A number beside one that is no yardstick: shown with its z, not judged.
    void guide(std::vector<std::string> state, Quantity quantity, Comparison comparison);
    /// A test of fit: only its p-value is known.
    void fit(std::vector<std::string> state, Quantity quantity, double p_value);
    /// A number without chance in it, that must lie within `bound` of the reference.
    void bound(std::vector<std::string> state, Quantity quantity, double value, double reference,
               double bound);

    /// Judges all: comparisons together and tests of fit together, each at the false alarm.
    void judge(Risks const& risks = {});
    std::vector<Entry> const& entries() const { return entries_; }
    /// Of one quantity over all states, or of all.
    Verdict verdict(std::string const& quantity = "") const;
    /// Of all quantities at one state.
    Verdict verdict_at(std::vector<std::string> const& state) const;

    Csv csv() const;           // for figures
    std::string table() const; // for the report
    std::string text() const;  // for the terminal

private:
    std::vector<Key> keys_;
    std::vector<Entry> entries_;
};

/// Judges, prints, writes the data, the table and the macros, to which it adds Verdict, Profile,
/// Comparisons, LargestZ and FalseAlarmPercent, and returns the verdict on all. A later look has a
/// tenth of the first one's false alarm, so that three looks have 1.2 times that of one.
Verdict conclude(Experiment& experiment, Ledger& ledger, Macros macros, Risks risks = {});

} // namespace clack::validation
