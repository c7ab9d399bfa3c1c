#pragma once
// The results of an experiment that compares many numbers of like kind: judged together, and left
// behind as one table.

#include "validation/harness/experiment.hpp"
#include "validation/harness/verdict.hpp"

#include <functional>
#include <string>
#include <vector>

namespace clack::validation {

/// One number beside what it should be.
struct Finding {
    std::string quantity;       // which number; the word that a plot script looks for
    std::string symbol;         // the same for the report, in TeX
    double at = 0;              // where: the abscissa
    Comparison comparison = {}; // its name is filled in
    Judgement judgement = {};   // filled in by judge
};

class Findings {
public:
    ///   abscissa   column name, with its unit
    ///   symbol     the same for the report, in TeX
    Findings(std::string abscissa, std::string symbol)
        : abscissa_(std::move(abscissa)), symbol_(std::move(symbol)) {}

    void add(Finding finding);
    /// One more verdict that the experiment's depends on, judged elsewhere.
    void require(Verdict verdict) { required_.push_back(verdict); }
    /// Judges all of them together.
    void judge(Risks const& risks = {});

    std::vector<Finding> const& all() const { return findings_; }
    Verdict verdict() const;

    /// Columns quantity, the abscissa, value, error, reference, reference_error, margin, z,
    /// verdict.
    Csv csv() const;
    std::string table() const;
    /// Profile, Points, LargestZ, FalseAlarmPercent and Verdict.
    Macros macros(std::string const& prefix, Profile profile) const;
    /// One line each, to standard output.
    void print() const;

    /// Judges, prints and writes csv, table and macros; what else the report quotes, `more`
    /// defines.
    Verdict conclude(Experiment& experiment, std::string const& prefix,
                     std::function<void(Macros&)> const& more = {});

private:
    std::string abscissa_, symbol_;
    std::vector<Finding> findings_;
    std::vector<Verdict> required_;
};

} // namespace clack::validation
