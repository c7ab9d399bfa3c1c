#include "validation/harness/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace clack::validation {

namespace {

using Kind = Entry::Kind;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Verdict verdict_of(std::vector<Entry> const& entries,
                   std::function<bool(Entry const&)> const& concerned) {
    std::vector<Verdict> verdicts;
    for (Entry const& entry : entries)
        if (entry.kind != Kind::guide && concerned(entry)) verdicts.push_back(entry.verdict);
    return together(verdicts);
}

/// What was expected, for people.
std::string expected(Comparison const& c) {
    return (c.asks == Asks::whether_apart ? "not " : "") +
           with_error({c.reference, c.reference_error});
}

} // namespace

void Ledger::compare(std::vector<std::string> state, Quantity quantity, Comparison comparison) {
    if (!keys_.empty() && state.size() != keys_.size())
        throw std::invalid_argument(fmt::format("{}: {} cells of its state point for {} keys",
                                                quantity.name, state.size(), keys_.size()));
    comparison.name = fmt::format("{} at {}", quantity.name, fmt::join(state, ", "));
    entries_.push_back(
        {{}, Kind::compared, std::move(state), std::move(quantity), std::move(comparison)});
}

void Ledger::guide(std::vector<std::string> state, Quantity quantity, Comparison comparison) {
    compare(std::move(state), std::move(quantity), std::move(comparison));
    Entry& entry = entries_.back();
    entry.kind = Kind::guide;
    entry.z = (entry.comparison.measured.value - entry.comparison.reference) /
              std::hypot(entry.comparison.measured.error, entry.comparison.reference_error);
}

void Ledger::fit(std::vector<std::string> state, Quantity quantity, double const p_value) {
    Comparison const none{
        .measured = {nan, nan}, .reference = nan, .reference_error = nan, .margin = nan};
    entries_.push_back(
        {{.z = nan}, Kind::fit, std::move(state), std::move(quantity), none, p_value});
}

void Ledger::bound(std::vector<std::string> state, Quantity quantity, double const value,
                   double const reference, double const bound) {
    compare(std::move(state), std::move(quantity),
            {.measured = {value, 0}, .reference = reference, .margin = bound});
    bool const within = std::abs(value - reference) <= bound; // not of what is not a number
    entries_.back().kind = Kind::bound;
    entries_.back().verdict = within ? Verdict::agrees : Verdict::differs;
}

void Ledger::judge(Risks const& risks) {
    std::vector<Comparison> comparisons;
    std::vector<double> p_values;
    for (Entry const& entry : entries_) {
        if (entry.kind == Kind::compared) comparisons.push_back(entry.comparison);
        if (entry.kind == Kind::fit) p_values.push_back(entry.p_value);
    }
    auto const judgements = validation::judge(comparisons, risks);
    auto const fitted = validation::judge(p_values, risks.false_alarm);
    std::size_t compared = 0, tested = 0;
    for (Entry& entry : entries_) {
        if (entry.kind == Kind::compared) static_cast<Judgement&>(entry) = judgements[compared++];
        if (entry.kind == Kind::fit) entry.verdict = fitted[tested++];
    }
}

Verdict Ledger::verdict(std::string const& quantity) const {
    return verdict_of(entries_, [&](Entry const& entry) {
        return quantity.empty() || entry.quantity.name == quantity;
    });
}

Verdict Ledger::verdict_at(std::vector<std::string> const& state) const {
    return verdict_of(entries_, [&](Entry const& entry) { return entry.state == state; });
}

Csv Ledger::csv() const {
    std::vector<std::string> keys;
    for (Key const& key : keys_) keys.push_back(key.name);
    Csv csv(cells(keys, "quantity", "measured", "measured_error", "reference", "reference_error",
                  "margin", "z", "p_value", "verdict"));
    for (Entry const& entry : entries_) {
        Comparison const& c = entry.comparison;
        csv.row(entry.state, entry.quantity.name, c.measured, c.reference, c.reference_error,
                c.margin, entry.z, entry.p_value, entry.word());
    }
    return csv;
}

std::string Ledger::table() const {
    std::vector<std::string> keys;
    for (Key const& key : keys_) keys.push_back(key.symbol);
    std::vector<std::vector<std::string>> rows;
    for (auto const& entry : entries_) {
        Comparison const& c = entry.comparison;
        auto numbers = cells(with_error(c.measured), expected(c), significant(c.margin, 2),
                             fmt::format("${:+.1f}$", entry.z));
        if (entry.kind == Kind::guide) numbers[2] = "";
        if (entry.kind == Kind::fit)
            numbers = {fmt::format("$p = {:.2f}$", entry.p_value), "", "", ""};
        if (entry.kind == Kind::bound) {
            numbers.front() = significant(c.measured.value, 6);
            numbers.back() = "";
        }
        rows.push_back(cells(entry.state, entry.quantity.symbol, numbers, entry.word()));
    }
    return tabular(std::string(keys.size(), 'r') + "lllrrl",
                   cells(keys, "quantity", "measured", "expected", "margin", "$z$", "verdict"),
                   rows);
}

std::string Ledger::text() const {
    std::string text;
    for (Entry const& entry : entries_) {
        Comparison const& c = entry.comparison;
        for (std::size_t k = 0; k < keys_.size(); ++k)
            text += fmt::format("{} {}, ", keys_[k].name, entry.state.at(k));
        std::string const found =
            fmt::format("{} reference {} margin {:.2g} z = {:+.1f}", with_error(c.measured),
                        expected(c), c.margin, entry.z);
        text +=
            fmt::format("{}: {}  {}\n", entry.quantity.name,
                        entry.kind == Kind::fit ? fmt::format("p = {:.3f}", entry.p_value) : found,
                        entry.word());
    }
    return text;
}

Verdict conclude(Experiment& experiment, Ledger& ledger, Macros macros, Risks risks) {
    if (experiment.look() > 1) risks.false_alarm /= 10;
    ledger.judge(risks);
    std::cout << ledger.text();
    int comparisons = 0;
    double largest_z = 0;
    for (Entry const& entry : ledger.entries()) {
        comparisons += entry.kind == Kind::compared;
        largest_z = std::max(largest_z, entry.against);
        experiment.note(entry.kind == Kind::fit ? deviate(entry.p_value) : entry.against);
    }
    macros.define("Profile", name_of(experiment.profile()));
    macros.define("Comparisons", cell(comparisons));
    macros.define("LargestZ", significant(largest_z, 2));
    macros.define("FalseAlarmPercent", significant(100 * risks.false_alarm, 1));
    macros.define("Verdict", name_of(ledger.verdict()));
    experiment.write(macros);
    experiment.write_table(ledger.table());
    experiment.write(ledger.csv());
    return ledger.verdict();
}

} // namespace clack::validation
