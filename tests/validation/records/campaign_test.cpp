#include "state/errors.hpp"
#include "validation/records/campaign.hpp"

#include "tests/validation/harness/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace clack;
using namespace clack::validation;

namespace {

std::string const point = "packing_fraction=0.2 count=500";

/// A measurement that leaves a trace of having been made.
struct Counted {
    int calls = 0;
    Measure measure = [this](std::uint64_t seed) {
        ++calls;
        return Measurement{static_cast<double>(seed) / 3, 1.0 / 3, -1e-300};
    };
};

/// Of a campaign's file: what a replicate took is never quite the same.
std::string without_seconds(std::string const& text) {
    return std::regex_replace(text, std::regex("[|][0-9.]+[|](?=[^|]* ;)"), "||");
}

} // namespace

BOOST_AUTO_TEST_CASE(finished_replicates_are_not_measured_again) {
    TemporaryDirectory const directory("campaign");
    Counted first;
    Campaign campaign("demo", directory.path, "p1");
    auto const measured = campaign.replicates(point, 3, first.measure);
    BOOST_TEST(first.calls == 3);
    BOOST_TEST(measured[1][0] == static_cast<double>(seed_of("demo", point, 1)) / 3);

    Counted second;
    Campaign resumed("demo", directory.path, "p1");
    auto const recalled = resumed.replicates(point, 5, second.measure);
    BOOST_TEST(second.calls == 2); // only the two that are new
    for (std::size_t k = 0; k < 3; ++k) BOOST_TEST(recalled[k] == measured[k]); // to the last bit
}

BOOST_AUTO_TEST_CASE(interrupted_campaign_keeps_what_was_finished) {
    TemporaryDirectory const directory("campaign");
    int calls = 0;
    auto const interrupted = [&](std::uint64_t) -> Measurement {
        if (++calls == 3) throw std::runtime_error("killed");
        return {1.0 * calls};
    };
    {
        Campaign campaign("demo", directory.path, "p1");
        BOOST_CHECK_THROW(campaign.replicates(point, 5, interrupted), std::runtime_error);
    }
    Counted rest;
    Campaign campaign("demo", directory.path, "p1");
    auto const all = campaign.replicates(point, 5, rest.measure);
    BOOST_TEST(rest.calls == 3);
    BOOST_TEST(all[0] == Measurement{1});
    BOOST_TEST(all[1] == Measurement{2});
}

BOOST_AUTO_TEST_CASE(line_that_a_kill_cut_short_is_dropped_wherever_it_was_cut) {
    TemporaryDirectory const directory("campaign");
    auto const path = directory.path / "demo.replicates";
    {
        Counted counted;
        Campaign("demo", directory.path, "p1").replicates(point, 2, counted.measure);
    }
    std::string const whole = text_of(path);
    std::size_t const last_line = whole.rfind('\n', whole.size() - 2) + 1;
    for (std::size_t cut = last_line; cut < whole.size() - 1; ++cut) {
        std::ofstream(path, std::ios::trunc) << whole.substr(0, cut);
        Counted counted;
        Campaign campaign("demo", directory.path, "p1");
        campaign.replicates(point, 2, counted.measure);
        BOOST_TEST(counted.calls == 1);
        BOOST_TEST(without_seconds(text_of(path)) == without_seconds(whole));
    }
}

BOOST_AUTO_TEST_CASE(new_program_starts_over) {
    TemporaryDirectory const directory("campaign");
    Counted old_program, new_program;
    Campaign("demo", directory.path, "p1").replicates(point, 2, old_program.measure);
    Campaign("demo", directory.path, "p2").replicates(point, 2, new_program.measure);
    BOOST_TEST(new_program.calls == 2);
}

BOOST_AUTO_TEST_CASE(state_points_have_their_own_replicates) {
    TemporaryDirectory const directory("campaign");
    Counted counted;
    Campaign campaign("demo", directory.path, "p1");
    campaign.replicates(point, 2, counted.measure);
    campaign.replicates(point + "0", 2, counted.measure);
    BOOST_TEST(counted.calls == 4);
}

BOOST_AUTO_TEST_CASE(state_points_that_cannot_be_told_apart_are_refused) {
    TemporaryDirectory const directory("campaign");
    Counted counted;
    Campaign campaign("demo", directory.path, "p1");
    auto const refused = [&](std::string const& one, std::string const& other) {
        BOOST_CHECK_THROW(
            campaign.replicates({{one, 2, counted.measure}, {other, 2, counted.measure}}),
            std::invalid_argument);
    };
    refused("x=1", "x=1");
    refused("x=1", "x=2|3");
    refused("x=1\n", "x=2");
    BOOST_TEST(counted.calls == 0);
}

BOOST_AUTO_TEST_CASE(state_points_measured_by_a_process_each_are_collected) {
    TemporaryDirectory const directory("campaign");
    Counted counted;
    std::vector<Task> const tasks{{"x=1", 2, counted.measure}, {"x=2", 3, counted.measure}};
    auto const campaign = [&](Share const share) {
        return Campaign("demo", directory.path, "p1", 0, share);
    };
    for (int const number : {2, 1})
        BOOST_CHECK_THROW(campaign({.point = number}).replicates(tasks), ShareDone);
    BOOST_TEST(counted.calls == 5);
    BOOST_CHECK_THROW(campaign({.point = 2}).replicates(tasks), ShareDone);
    BOOST_CHECK_THROW(campaign({.listed = true}).replicates(tasks), ShareDone);
    BOOST_CHECK_THROW(campaign({.point = 3}).replicates(tasks), InputError);
    auto const collected = campaign({}).replicates(tasks);
    BOOST_TEST(counted.calls == 5); // nothing is measured twice
    BOOST_TEST(collected[1][2][0] == static_cast<double>(seed_of("demo", "x=2", 2)) / 3);
    BOOST_TEST(!std::filesystem::exists(directory.path / "demo.replicates.1"));
    campaign({}).replicates(tasks);
    BOOST_TEST(counted.calls == 5);
}

BOOST_AUTO_TEST_CASE(other_seed_sets_have_other_seeds_and_replicates) {
    TemporaryDirectory const directory("campaign");
    Counted counted;
    auto const first =
        Campaign("demo", directory.path, "p1", 1).replicates(point, 2, counted.measure);
    auto const other =
        Campaign("demo", directory.path, "p1", 2).replicates(point, 2, counted.measure);
    BOOST_TEST(counted.calls == 4);
    BOOST_TEST(first[0][0] != other[0][0]);
}

BOOST_AUTO_TEST_CASE(every_replicate_costs_once_however_often_it_is_asked_for) {
    TemporaryDirectory const directory("campaign");
    // Replicates of an earlier run, which looked twice: a thousand seconds each.
    std::string text = "# replicates of demo, program p1\n";
    for (int number = 0; number < 4; ++number)
        text += "x=1|" + std::to_string(number) + "|7|1000|1 ;\n";
    std::ofstream(directory.path / "demo.replicates") << text;
    Counted counted;
    Campaign campaign("demo", directory.path, "p1");
    std::vector<Task> const tasks{{"x=1", 2, counted.measure}};
    auto const thousands = [&] {
        BOOST_TEST(campaign.replicates(tasks).size() == 1);
        return std::floor(campaign.seconds() / 1000); // what the test itself takes is less
    };
    BOOST_TEST(thousands() == 2);
    BOOST_TEST(thousands() == 2);
    BOOST_TEST(campaign.lengthen());
    BOOST_TEST(thousands() == 4);
    BOOST_TEST(counted.calls == 0);
    BOOST_TEST(campaign.lengthen());
    BOOST_TEST(thousands() == 4); // the other four were measured now, in no time
    BOOST_TEST(counted.calls == 4);
    BOOST_TEST(thousands() == 4);
    BOOST_TEST(campaign.seconds("x=1") == 4000, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(values_that_are_no_numbers_come_back) {
    TemporaryDirectory const directory("campaign");
    auto const odd = [](std::uint64_t) { return Measurement{INFINITY, NAN}; };
    Campaign("demo", directory.path, "p1").replicates(point, 1, odd);
    Counted counted;
    auto const recalled =
        Campaign("demo", directory.path, "p1").replicates(point, 1, counted.measure);
    BOOST_TEST(counted.calls == 0);
    BOOST_TEST(std::isinf(recalled[0][0]));
    BOOST_TEST(std::isnan(recalled[0][1]));
}

BOOST_AUTO_TEST_CASE(directory_that_cannot_be_written_is_the_users_mistake) {
    BOOST_CHECK_THROW(Campaign("demo", "/nowhere/at/all", "p1"), InputError);
}

BOOST_AUTO_TEST_CASE(seeds_depend_on_experiment_point_and_replicate_alone) {
    BOOST_TEST(seed_of("a", "b", 0) == seed_of("a", "b", 0));
    std::set<std::uint64_t> seeds;
    for (char const* experiment : {"eos", "velocity"})
        for (char const* state_point : {"x=1", "x=2", "x=12"})
            for (int replicate = 0; replicate < 1000; ++replicate)
                seeds.insert(seed_of(experiment, state_point, replicate));
    BOOST_TEST(seeds.size() == 6000);
    BOOST_TEST(*seeds.rbegin() <= static_cast<std::uint64_t>(INT64_MAX));
}

BOOST_AUTO_TEST_CASE(seeds_are_the_same_on_every_machine) {
    // FNV-1a of "" is its offset basis, 0xcbf29ce484222325; of "a" 0xaf63dc4c8601ec8c (published).
    // What is expected here is splitmix64's finaliser of these.
    auto const avalanche = [](std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    };
    BOOST_TEST(hash_of("") == avalanche(0xcbf29ce484222325u));
    BOOST_TEST(hash_of("a") == avalanche(0xaf63dc4c8601ec8cu));
}

BOOST_AUTO_TEST_CASE(program_is_known_by_its_content) {
    BOOST_TEST(program_hash().size() == 16);
    BOOST_TEST(program_hash() != "0000000000000000");
    BOOST_TEST(program_hash() == program_hash());
}
