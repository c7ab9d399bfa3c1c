// What does a scene pay for an ingredient that it does not need, and is the model that `auto`
// chooses for it the quickest?

#include "validation/price_of_generality.hpp"

#include "simulation/model_choice.hpp"
#include "validation/harness/experiment.hpp"

#include <algorithm>
#include <iostream>

namespace clack::validation {

using namespace price;

Question const question{
    "price_of_generality",
    "Is `auto` as fast as the best method for every number of balls and packing fraction, and what "
    "does each ingredient cost that a scene does not need?",
    "0.9 times the collisions per second of each method",
    "beside the bounds of its choices two methods are equally good; the costs are charted, not "
    "judged"};

namespace {

struct Plan {
    Plain plain;
    std::vector<Point> points;
    int replicates;
};

Plan plan(Profile const profile) {
    bool const full = profile == Profile::full;
    Plan made{{.count = 1'000,
               .packing_fraction = 0.2,
               .slice = full ? 5'000u : 500u,
               .rounds = full ? 51 : 25},
              {},
              full ? 9 : 5};
    std::vector<std::int64_t> counts{2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 100, 200, 500, 2'000};
    if (full) counts.insert(counts.end(), {8'000, 32'000});
    for (Boundary const boundary : {Boundary::walls, Boundary::periodic}) {
        for (double const packing_fraction : {0.01, 0.05, 0.2, 0.4, 0.49}) {
            for (std::int64_t const count : counts) {
                Point const point{boundary, count, packing_fraction, full ? 15 : 3};
                if (point.has_room()) made.points.push_back(point);
            }
        }
    }
    return made;
}

/// `auto` beside one other method somewhere.
struct Contest {
    Point point;
    std::size_t method;
    Estimate factor; // rate of `auto` over the method's
    Verdict verdict = Verdict::undecided;
};

std::vector<Contest> contests_at(Point const& point, int const replicates, Campaign& campaign) {
    auto const measured = campaign.replicates(
        point.text(), replicates, [&](std::uint64_t const seed) { return measure(point, seed); });
    std::vector<Contest> all;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        std::vector<double> factors;
        for (Measurement const& replicate : measured) factors.push_back(replicate[m]);
        if (factors.front() < infinity<double>) all.push_back({point, m, median_of(factors)});
    }
    return all;
}

void decide(std::vector<Contest>& contests) {
    std::vector<Comparison> comparisons;
    for (Contest const& contest : contests) comparisons.push_back(at_least(0.9, contest.factor));
    auto const judgements = judge(comparisons, of_timing);
    for (std::size_t k = 0; k < contests.size(); ++k) contests[k].verdict = judgements[k].verdict;
}

std::vector<Contest> contests(Plan const& plan, Campaign& campaign) {
    std::vector<std::vector<Contest>> by_point(plan.points.size());
    std::vector<Contest> all;
    auto const measure = [&](std::size_t const k, int const times) {
        by_point[k] = contests_at(plan.points[k], times * plan.replicates, campaign);
    };
    measure_until_decided(by_point.size(), measure, [&] {
        all.clear();
        std::vector<bool> open;
        for (auto const& some : by_point) all.insert(all.end(), some.begin(), some.end());
        decide(all);
        for (Point const& point : plan.points)
            open.push_back(std::any_of(all.begin(), all.end(), [&](Contest const& contest) {
                return contest.verdict == Verdict::undecided &&
                       contest.point.text() == point.text();
            }));
        return open;
    });
    return all;
}

/// What an ingredient costs over the plain run, and how long the two go one way.
struct Price {
    char const* name;
    Priced priced;
    Estimate cost;
    double in_common; // meetings of a ball, least of all replicates; infinity for the same bits
};

std::vector<Price> prices(Plan const& plan, Campaign& campaign) {
    auto const measured =
        campaign.replicates(plan.plain.text(), plan.replicates,
                            [&](std::uint64_t const seed) { return measure(plan.plain, seed); });
    std::vector<Price> all;
    for (std::size_t k = 0; k < ingredients().size(); ++k) {
        std::vector<double> costs;
        double least = infinity<double>;
        for (Measurement const& replicate : measured) {
            costs.push_back(replicate[2 * k]);
            least = std::min(least, replicate[2 * k + 1]);
        }
        all.push_back({ingredients()[k].name, ingredients()[k].priced, median_of(costs), least});
    }
    return all;
}

Csv csv_of(std::vector<Price> const& all) {
    Csv csv(
        {"ingredient", "priced", "cost_over_plain", "cost_error", "meetings_in_common_per_ball"});
    for (Price const& price : all)
        csv.row({price.name, price.priced == Priced::whole ? "whole" : "from_below",
                 cell(price.cost.value), cell(price.cost.error), cell(price.in_common)});
    return csv;
}

/// One row a state point. Over a method that `auto` itself is its rate is 1.
Csv csv_of(Plan const& plan, std::vector<Contest> const& all) {
    Csv csv({"boundary", "count", "packing_fraction", "search", "queue", "auto_over_table",
             "auto_over_table_error", "auto_over_heap", "auto_over_heap_error", "auto_over_fast",
             "auto_over_fast_error", "auto_over_best", "auto_over_best_error"});
    for (Point const& point : plan.points) {
        System const system = point.system();
        std::array<Estimate, methods.size()> over;
        over.fill({.value = 1});
        for (Contest const& contest : all)
            if (contest.point.text() == point.text()) over[contest.method] = contest.factor;
        ModelDescription const chosen =
            describe(choose_model(system, Method::automatic, Precision::double_), system,
                     Precision::double_);
        std::vector<std::string> row{chosen.boundary, cell(point.count),
                                     cell(point.packing_fraction), chosen.search, chosen.queue};
        auto const add = [&](Estimate const& factor) {
            row.push_back(cell(factor.value));
            row.push_back(cell(factor.error));
        };
        std::for_each(over.begin(), over.end(), add);
        add(*std::min_element(over.begin(), over.end(),
                              [](auto const& a, auto const& b) { return a.value < b.value; }));
        csv.row(row);
    }
    return csv;
}

Macros macros_of(Plan const& plan, std::vector<Price> const& costs, std::vector<Contest> const& all,
                 Verdict const verdict) {
    Macros macros("PriceOfGenerality");
    macros.define("Verdict", name_of(verdict));
    macros.define("Count", fmt::format("{}", plan.plain.count));
    macros.define("PackingFraction", fmt::format("{}", plan.plain.packing_fraction));
    macros.define("Replicates", fmt::format("{}", plan.replicates));
    macros.define("Points", fmt::format("{}", plan.points.size()));
    macros.define("Ingredients", fmt::format("{}", costs.size()));
    macros.define("LargestCount", fmt::format("{}", plan.points.back().count));
    auto const least = std::min_element(all.begin(), all.end(), [](auto const& a, auto const& b) {
        return a.factor.value < b.factor.value;
    });
    macros.define("LeastFactor", with_error(least->factor));
    macros.define("LeastFactorMethod", name_of(methods[least->method]));
    macros.define("LeastFactorCount", fmt::format("{}", least->point.count));
    macros.define("LeastFactorPackingFraction", fmt::format("{}", least->point.packing_fraction));
    return macros;
}

} // namespace

Verdict ask(Experiment& experiment) {
    Plan const all = plan(experiment.profile());
    auto const costs = prices(all, experiment.campaign());
    auto const judged = contests(all, experiment.campaign());
    for (Price const& price : costs)
        std::cout << fmt::format(
            "{:26} {:>10} times the plain run; the same {}\n", price.name, with_error(price.cost),
            price.in_common < infinity<double>
                ? fmt::format("first {:.1f} meetings of a ball", price.in_common)
                : "bits");
    std::vector<Verdict> verdicts;
    for (Contest const& contest : judged) {
        verdicts.push_back(contest.verdict);
        if (contest.factor.value < 1 || contest.verdict != Verdict::agrees)
            std::cout << fmt::format("{}: {} times the rate of {}  {}\n", contest.point.text(),
                                     with_error(contest.factor), name_of(methods[contest.method]),
                                     name_of(contest.verdict));
    }
    Verdict const verdict = together(verdicts);
    experiment.write(csv_of(costs));
    experiment.write(csv_of(all, judged), "_auto");
    experiment.write(macros_of(all, costs, judged, verdict));
    return verdict;
}

} // namespace clack::validation
