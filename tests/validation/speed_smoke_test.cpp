// The experiment on speed: factors are judged, parts are told apart, a slow method and one that
// goes another way are caught.

#include "validation/speed_targets.hpp"

#include <boost/test/unit_test.hpp>

#include <numeric>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::speed;

namespace {

Point const small{.count = 600,
                  .packing_fraction = 0.4,
                  .equilibration = 4,
                  .collisions = 900,
                  .table_collisions = 120};

Ledger ledger_with(MethodMaker const& make) {
    Found found{small, {}};
    for (std::uint64_t seed = 0; seed < 5; ++seed)
        found.replicates.push_back(measure(small, seed, {}, make));
    return ledger_of({found});
}

Verdict judged(double const value, double const error) {
    return judge({{.measured = {value, error, 4},
                   .reference = least,
                   .asks = Asks::whether_at_least}},
                 of_timing)
        .front()
        .verdict;
}

} // namespace

BOOST_AUTO_TEST_CASE(median_is_not_moved_by_one_disturbed_replicate) {
    BOOST_TEST(median_of({5, 1, 2, 3, 900}).value == 3);
    BOOST_TEST(median_of({4, 1, 2, 3}).value == 2.5);
}

BOOST_AUTO_TEST_CASE(factor_agrees_from_the_least_on) {
    BOOST_TEST((judged(1.2, 0.03) == Verdict::agrees));
    BOOST_TEST((judged(80, 2) == Verdict::agrees));
    BOOST_TEST((judged(0.91, 0.03) == Verdict::undecided));
    BOOST_TEST((judged(0.5, 0.01) == Verdict::differs));
}

BOOST_AUTO_TEST_CASE(peer_is_called_with_its_arguments_and_its_last_line_is_read) {
    auto const rate = [](std::string const& command) {
        return 1 / peer_seconds(command, 500, 0.25, 20, 1000, 7);
    };
    for (auto const& [place, value] :
         {std::pair{1, 500.0}, {2, 0.25}, {3, 20.0}, {4, 4.0}, {5, 7.0}})
        BOOST_TEST(rate(fmt::format("sh -c 'echo rate; echo ${}' sh", place)) == value,
                   boost::test_tools::tolerance(1e-12));
    BOOST_TEST(std::isnan(rate("echo it cannot:")));
    BOOST_TEST(std::isnan(rate("false")));
}

BOOST_AUTO_TEST_CASE(being_watched_leaves_no_trace) {
    for (Boundary const boundary : boundaries) {
        for (Method const method : methods) {
            System const system = cube(boundary, small.count, small.packing_fraction);
            Start const start = lattice_start(system, 1);
            auto const alone = make_true_method(system, method, start);
            auto const seen = boundary == Boundary::walls
                                  ? watched<WalledCube>(system, method, start)
                                  : watched<PeriodicCube>(system, method, start);
            alone->advance({.ball_collisions = 200});
            seen->advance({.ball_collisions = 200});
            BOOST_TEST(seen->time() == alone->time());
        }
    }
}

BOOST_AUTO_TEST_CASE(parts_are_told_apart) {
    System const system = small.system(in_periodic);
    Start const start = lattice_start(system, 1);
    Shares const by_table = shares(system, Method::table, start, 100);
    Shares const by_heap = shares(system, Method::heap, start, 1000);
    auto const share = [](Shares const& all, Part const part) {
        return all[static_cast<std::size_t>(part)];
    };
    for (Shares const& all : {by_table, by_heap})
        BOOST_TEST(std::accumulate(all.begin(), all.end(), 0.0) == 1,
                   boost::test_tools::tolerance(1e-12));
    // All other balls are candidates of the table's: nothing is gathered, everything predicted.
    BOOST_TEST(share(by_table, Part::prediction) > 0.5);
    BOOST_TEST(share(by_table, Part::search) < 0.1);
    BOOST_TEST(share(by_heap, Part::search) > 0.05);
    BOOST_TEST(share(by_heap, Part::queue) > 0.05);
}

BOOST_AUTO_TEST_CASE(bytes_and_parts_are_measured_of_every_method) {
    Point watched = small;
    watched.watched = true;
    double const begin = processor_seconds();
    Measurement const all = measure(watched, 1);
    double const taken = processor_seconds() - begin;
    double timed = 0;
    for (std::size_t const b : {in_periodic, in_walls}) {
        for (std::size_t const method : {table, heap, fast}) {
            timed += all[place_of(b, method)] * static_cast<double>(small.collisions_of(method));
            BOOST_TEST(all[place_of(b, method)] > 0);
            BOOST_TEST(all[place_of(b, method, bytes)] > sizeof(Ball<double>));
            BOOST_TEST(all[place_of(b, method, bytes)] < 50 * sizeof(Ball<double>));
            auto const parts =
                all.begin() + static_cast<std::ptrdiff_t>(place_of(b, method, first_part));
            double const sum = std::accumulate(parts, parts + part_count, 0.0);
            BOOST_TEST((b == in_periodic ? std::abs(sum - 1) < 1e-12 : std::isnan(sum)));
        }
        BOOST_TEST(std::isnan(all[place_of(b, peer)]));
    }
    BOOST_TEST(timed < taken);
    BOOST_TEST(timed > 1e-3 * taken); // beside starts and the search for parts
    // Each method's parts are its own: the table gathers nothing and predicts everything.
    auto const share = [&](std::size_t const method, Part const part) {
        return all[place_of(in_periodic, method, first_part + static_cast<std::size_t>(part))];
    };
    BOOST_TEST(share(table, Part::search) < 0.1);
    for (std::size_t const method : {heap, fast}) {
        BOOST_TEST(share(method, Part::search) > 0.02);
        BOOST_TEST(share(table, Part::prediction) > share(method, Part::prediction));
    }
}

// The mutant: `fast` that scans all balls.
BOOST_AUTO_TEST_CASE(fast_method_that_is_slow_is_caught) {
    Ledger const slow =
        ledger_with([](System const& system, Method const method, Start const& start) {
            return make_true_method(system, method == Method::fast ? Method::table : method, start);
        });
    BOOST_TEST((slow.verdict("fast_over_heap") == Verdict::differs));
    BOOST_TEST((ledger_with(make_true_method).verdict() != Verdict::differs));
}

BOOST_AUTO_TEST_CASE(method_that_goes_another_way_is_caught) {
    auto const strays = [](System const& system, Method const method, Start start) {
        if (method == Method::fast) start.velocities(0, 0) += 1e-12;
        return make_true_method(system, method, start);
    };
    BOOST_CHECK_THROW(measure(small, 1, {}, strays), LawBroken);
}
