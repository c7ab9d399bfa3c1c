// The experiment on cost: exponents are found, and a method that scans is caught.

#include "validation/complexity.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::complexity;

namespace {

Plan const small{.packing_fraction = 0.2,
                 .equilibration = 1,
                 .smallest = 256,
                 .largest_fitted = 2'048,
                 .ladders = {{Method::fast, 2'048, 500, 1, 0}},
                 .replicates = 8}; // one sweep that another process disturbed does not decide

/// The verdicts on start and collision when `make` is put to the test.
std::vector<Judgement> judged(MethodMaker const& make) {
    std::vector<Measurement> sweeps;
    for (int replicate = 0; replicate < small.replicates; ++replicate)
        sweeps.push_back(measure(small, static_cast<std::uint64_t>(replicate), make));
    return judge(
        {compare(small, 0, Work::start, sweeps), compare(small, 0, Work::collision, sweeps)},
        of_timing);
}

} // namespace

BOOST_AUTO_TEST_CASE(power_of_exact_costs_is_found) {
    std::vector<std::int64_t> const counts{512, 1024, 2048};
    Power const power = fit_power(counts, {8, 16 * std::sqrt(2.0), 64});
    BOOST_TEST(power.exponent == 1.5, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(power.at(1024) == 16 * std::sqrt(2.0), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(costs_are_taken_from_their_own_ladder) {
    Plan plan = small;
    plan.ladders = {{Method::table, 512, 10, 2, 1}, {Method::fast, 1024, 10, 1, 0}};
    Measurement const sweep{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    auto const costs = [&](std::size_t ladder, Work quantity) {
        return costs_of(plan, ladder, quantity, sweep);
    };
    BOOST_TEST(costs(0, Work::start) == (std::vector<double>{1, 3}));
    BOOST_TEST(costs(0, Work::collision) == (std::vector<double>{2, 4}));
    BOOST_TEST(costs(1, Work::start) == (std::vector<double>{5, 7, 9}));
    BOOST_TEST(costs(1, Work::collision) == (std::vector<double>{6, 8, 10}));
}

// The mutant: cells that are never used, all balls being scanned instead.
BOOST_AUTO_TEST_CASE(method_that_scans_all_balls_is_caught) {
    auto const judgements = judged([](System const& system, Method, Start const& start) {
        return make_engine(system, Method::table, Precision::double_, start);
    });
    BOOST_TEST((judgements[0].verdict == Verdict::differs));
    BOOST_TEST((judgements[1].verdict == Verdict::differs));
    BOOST_TEST(judgements[1].z > 0);
}
