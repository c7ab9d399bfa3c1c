// What does a scene pay for an ingredient that it does not need, and is the model that `auto`
// chooses for it the quickest?

#include "validation/price_of_generality.hpp"

#include <algorithm>

namespace clack::validation {

using namespace price;

Question const question{
    "price_of_generality",
    "Is `auto` as fast as the best method for every number of balls and packing fraction, and what "
    "does each ingredient cost that a scene does not need?",
    fmt::format("{} times the collisions per second of each method", least),
    "beside the bounds of its choices two methods are equally good; the costs are charted, not "
    "judged"};

namespace {

/// What each ingredient costs, a guide; then what is asked of `auto` at each point.
Ledger ledger_of(Plain const& plain, std::vector<Measurement> const& costs,
                 std::vector<Point> const& points,
                 std::vector<std::vector<Measurement>> const& rates) {
    Ledger ledger({{"boundary", ""}, {"count", "$n$"}, {"packing_fraction", "$\\eta$"}});
    for (std::size_t k = 0; k < ingredients().size(); ++k)
        ledger.guide({"walls", cell(plain.count), cell(plain.packing_fraction)},
                     {ingredients()[k].name, ingredients()[k].name},
                     {.measured = median_of(costs, [=](Measurement const& m) { return m[k]; }),
                      .reference = 1});
    for (std::size_t p = 0; p < points.size(); ++p) enter(ledger, points[p], rates[p]);
    ledger.judge(of_timing);
    return ledger;
}

/// The model that `auto` chooses, and its rate over that of the best method, which it may itself
/// be.
Csv choices_of(std::vector<Point> const& points, Ledger const& ledger) {
    Csv csv({"boundary", "count", "packing_fraction", "search", "queue", "auto_over_best"});
    for (Point const& point : points) {
        double best = 1;
        for (Entry const& entry : ledger.entries())
            if (entry.kind == Entry::Kind::compared && entry.state == point.state())
                best = std::min(best, entry.comparison.measured.value);
        ModelDescription const chosen =
            describe(choose_model(point.system(), Method::automatic, Precision::double_),
                     point.system(), Precision::double_);
        auto row = point.state();
        row.insert(row.end(), {chosen.search, chosen.queue, cell(best)});
        csv.row(row);
    }
    return csv;
}

} // namespace

Verdict ask(Experiment& experiment) {
    Plain const plain = price::plain(experiment.profile());
    auto const costs = experiment.campaign().replicates(
        plain.text(), plain.replicates, [&](std::uint64_t seed) { return measure(plain, seed); });
    auto const points = price::points(experiment.profile());
    std::vector<std::vector<Measurement>> rates(points.size());
    auto const measure_at = [&](std::size_t const k, int const times) {
        rates[k] = experiment.campaign().replicates(
            points[k].text(), times * points[k].replicates,
            [&](std::uint64_t const seed) { return measure(points[k], seed); });
    };
    measure_until_decided(points.size(), measure_at, [&] {
        Ledger const ledger = ledger_of(plain, costs, points, rates);
        std::vector<bool> open;
        for (Point const& point : points)
            open.push_back(ledger.verdict_at(point.state()) == Verdict::undecided);
        return open;
    });
    Ledger ledger = ledger_of(plain, costs, points, rates);
    Macros macros("PriceOfGenerality");
    macros.define("Count", cell(plain.count));
    macros.define("PackingFraction", fmt::format("{}", plain.packing_fraction));
    macros.define("Points", cell(points.size()));
    macros.define("LargestCount", cell(points.back().count));
    Entry const slowest = std::ranges::min(ledger.entries(), {}, [](Entry const& entry) {
        bool const judged = entry.kind == Entry::Kind::compared;
        return judged ? entry.comparison.measured.value : infinity<double>;
    });
    macros.define("LeastFactor", with_error(slowest.comparison.measured));
    macros.define("LeastFactorMethod", slowest.quantity.symbol);
    macros.define("LeastFactorCount", slowest.state[1]);
    macros.define("LeastFactorPackingFraction", slowest.state[2]);
    experiment.write(choices_of(points, ledger), "_auto");
    return conclude(experiment, ledger, macros, of_timing);
}

} // namespace clack::validation
