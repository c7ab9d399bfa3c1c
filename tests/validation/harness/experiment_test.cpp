#include "reference/published_table.hpp"
#include "state/errors.hpp"
#include "validation/harness/experiment.hpp"
#include "validation/harness/ledger.hpp"

#include "tests/validation/harness/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <stdexcept>
#include <string>
#include <vector>

using namespace clack;
using namespace clack::validation;

namespace {

Question const demo{"demo", "does two and two make four?", "none", "it is arithmetic"};

int run_with(std::vector<char const*> arguments, std::function<Verdict(Experiment&)> const& ask) {
    arguments.insert(arguments.begin(), "demo");
    return run(static_cast<int>(arguments.size()), arguments.data(), demo, ask);
}

Verdict never(Experiment&) {
    BOOST_FAIL("must not be asked");
    return Verdict::undecided;
}

} // namespace

BOOST_AUTO_TEST_CASE(verdict_is_the_exit_code) {
    TemporaryDirectory const directory("experiment");
    std::vector<char const*> const there{"-o", directory.path.c_str()};
    BOOST_TEST(run_with(there, [](Experiment&) { return Verdict::agrees; }) == 0);
    BOOST_TEST(run_with(there, [](Experiment&) { return Verdict::differs; }) == 1);
    BOOST_TEST(run_with(there, [](Experiment&) { return Verdict::undecided; }) == 1);
    BOOST_TEST(run_with(there, [](Experiment&) -> Verdict { throw LawBroken("overlap"); }) == 1);
    BOOST_TEST(run_with(there, [](Experiment&) -> Verdict { throw InputError("no"); }) == 2);
    // The experiment's own mistake is told too, and is no verdict.
    BOOST_TEST(run_with(there, [](Experiment&) -> Verdict { throw std::logic_error("no"); }) == 2);
}

BOOST_AUTO_TEST_CASE(what_cannot_be_judged_is_refused_by_its_name) {
    Ledger ledger({{"count", ""}, {"packing_fraction", ""}});
    Quantity const pressure{"pressure", "$P$"};
    Comparison const scatterless{.measured = {12, 0}, .reference = 12, .margin = 0.5};
    BOOST_CHECK_THROW(ledger.compare({"500"}, pressure, scatterless), std::invalid_argument);
    ledger.compare({"500", "0.4"}, pressure, scatterless);
    BOOST_CHECK_EXCEPTION(ledger.judge(), std::invalid_argument, [](auto const& mistake) {
        return std::string(mistake.what()).starts_with("pressure at 500, 0.4: ");
    });
}

BOOST_AUTO_TEST_CASE(options_say_how_much_and_where) {
    TemporaryDirectory const directory("experiment");
    auto const nested = (directory.path / "a" / "b").string();
    BOOST_TEST(run_with({"--profile", "full", "-o", nested.c_str()}, [](Experiment& experiment) {
                   return experiment.profile() == Profile::full ? Verdict::agrees
                                                                : Verdict::differs;
               }) == 0);
    BOOST_TEST(std::filesystem::is_directory(nested));
    BOOST_TEST(run_with({"-o", nested.c_str()}, [](Experiment& experiment) {
                   return experiment.profile() == Profile::quick ? Verdict::agrees
                                                                 : Verdict::differs;
               }) == 0);
}

BOOST_AUTO_TEST_CASE(mistakes_on_the_command_line_are_the_users) {
    BOOST_TEST(run_with({"--profile", "slow"}, never) == 2);
    BOOST_TEST(run_with({"--colour"}, never) == 2);
    BOOST_TEST(run_with({"-o", "/proc/nowhere"}, never) == 2);
    BOOST_TEST(run_with({"--help"}, never) == 0);
}

BOOST_AUTO_TEST_CASE(what_is_undecided_is_asked_again_of_more_replicates) {
    TemporaryDirectory const directory("experiment");
    std::vector<char const*> const there{"-o", directory.path.c_str()};
    int measured = 0;
    std::vector<std::size_t> looks;
    // Decided by sixteen replicates, or by none.
    auto const ask_with = [&](std::string const& state, std::size_t const enough) {
        return [&, state, enough](Experiment& experiment) {
            auto const all = experiment.campaign().replicates({{state, 4, [&](std::uint64_t) {
                                                                    ++measured;
                                                                    return Measurement{1};
                                                                }}});
            looks.push_back(all.front().size());
            return all.front().size() < enough ? Verdict::undecided : Verdict::agrees;
        };
    };
    BOOST_TEST(run_with(there, ask_with("a", 16)) == 0);
    BOOST_TEST(looks == (std::vector<std::size_t>{4, 8, 16}), boost::test_tools::per_element());
    BOOST_TEST(measured == 16);
    BOOST_TEST(run_with(there, ask_with("b", 17)) == 1);
    BOOST_TEST(looks.size() == 6u);
    // A question without tasks cannot be asked of more.
    int asked = 0;
    BOOST_TEST(run_with(there, [&](Experiment&) {
                   ++asked;
                   return Verdict::undecided;
               }) == 1);
    BOOST_TEST(asked == 1);
}

// So that three looks raise 1.2 times the false alarms of one.
BOOST_AUTO_TEST_CASE(later_looks_have_a_tenth_of_the_risk_of_the_first) {
    TemporaryDirectory const directory("experiment");
    // A value that lies so far beyond its margin at one look, and at the others on it.
    auto const verdict_with = [&](int const look, double const errors_beyond) {
        Verdict last = Verdict::agrees;
        run_with({"-o", directory.path.c_str()}, [&](Experiment& experiment) {
            experiment.campaign().replicates(
                {{"a", 2, [](std::uint64_t) { return Measurement{1}; }}});
            Ledger ledger({Key{"sum", "$s$"}});
            double const beyond = experiment.look() == look ? errors_beyond : 0;
            ledger.compare({"2"}, {"four", "$4$"},
                           {.measured = {1 + beyond, 1}, .reference = 0, .margin = 1});
            last = conclude(experiment, ledger, Macros("Demo"), {.false_alarm = 1e-3});
            BOOST_TEST(text_of(directory.path / "demo.tex")
                           .find(experiment.look() == 1
                                     ? "FalseAlarmPercent}{0.1}"
                                     : "FalseAlarmPercent}{0.01}") != std::string::npos);
            return last;
        });
        return last;
    };
    constexpr double rare = 3.35, rarer = 4; // 4e-4, 3e-5
    BOOST_TEST((verdict_with(1, rare) == Verdict::differs));
    for (int const look : {2, 3}) {
        BOOST_TEST((verdict_with(look, rare) == Verdict::undecided));
        // The summary's worst z is the last look's.
        BOOST_TEST(text_of(directory.path / "demo_verdict.csv")
                       .find(look == 3 ? ",none,4.35,undecided," : ",none,1,undecided,") !=
                   std::string::npos);
        BOOST_TEST((verdict_with(look, rarer) == Verdict::differs));
    }
}

BOOST_AUTO_TEST_CASE(experiment_that_is_not_shared_out_is_not_asked_for_a_share) {
    TemporaryDirectory const directory("experiment");
    BOOST_TEST(run_with({"-o", directory.path.c_str(), "--list"}, never) == 0);
    BOOST_TEST(run_with({"-o", directory.path.c_str(), "--point", "1"}, never) == 2);
    BOOST_TEST(run_with({"--list", "--point", "1"}, never) == 2);
}

BOOST_AUTO_TEST_CASE(results_say_where_they_come_from) {
    TemporaryDirectory const directory("experiment");
    auto const ask = [](Experiment& experiment) {
        Csv csv({"number", "doubled"});
        csv.row({cell(2), cell(4)});
        experiment.write(csv);
        experiment.write(csv, "_again");
        Macros macros("Demo");
        macros.define("Sum", "4");
        experiment.write(macros);
        experiment.write_table(tabular("r", {"sum"}, {{"4"}}));
        return Verdict::agrees;
    };
    BOOST_REQUIRE(run_with({"-o", directory.path.c_str()}, ask) == 0);
    std::string const csv = text_of(directory.path / "demo.csv");
    for (char const* line :
         {"# experiment: demo", "# question: does two", "# profile: quick", "# commit: ",
          "# program: ", "# compiler: ", "# machine: ", "# seeds: ", "# margin: none: it is"})
        BOOST_TEST(csv.find(line) != std::string::npos, line);
    reference::PublishedTable const table(directory.path / "demo_again.csv");
    BOOST_TEST(table.column("doubled").at(0) == 4);
    BOOST_TEST(text_of(directory.path / "demo.tex").find("\\newcommand{\\DemoSum}{4}") !=
               std::string::npos);
    BOOST_TEST(text_of(directory.path / "demo_table.tex").starts_with("\\begin{tabular}"));
    BOOST_TEST(text_of(directory.path / "demo_verdict.tex")
                   .starts_with("\\texttt{demo} & 0 & none & -- & agrees & "));
}

BOOST_AUTO_TEST_CASE(fit_is_worth_the_deviate_that_is_as_rare_in_the_summary) {
    TemporaryDirectory const directory("experiment");
    auto const ask = [](Experiment& experiment) {
        Ledger ledger({Key{"sum", "$s$"}});
        ledger.fit({"2"}, {"four", "$4$"}, 0.0455);
        return conclude(experiment, ledger, Macros("Demo"));
    };
    BOOST_TEST(run_with({"-o", directory.path.c_str()}, ask) == 0);
    BOOST_TEST(text_of(directory.path / "demo_verdict.tex").find("& none & 2.0 & agrees") !=
               std::string::npos);
    BOOST_TEST(
        text_of(directory.path / "demo.csv").find("2,four,nan,nan,nan,nan,nan,nan,0.0455,agrees") !=
        std::string::npos);
    BOOST_TEST(
        text_of(directory.path / "demo_table.tex").find("2 & $4$ & $p = 0.05$ &  &  &  & agrees") !=
        std::string::npos);
}

BOOST_AUTO_TEST_CASE(ledger_is_judged_together_and_left_behind) {
    TemporaryDirectory const directory("experiment");
    auto const concluded = [&](double const measured, double const to_be_told_apart) {
        Options options;
        options.directory = directory.path;
        Experiment experiment(demo, options);
        Ledger ledger({Key{"sum", "$s$"}});
        ledger.compare({"2"}, {"four", "$4$"},
                       {.measured = {4, 0.0078125}, .reference = 4, .margin = 0.125});
        ledger.compare({"3"}, {"five", "$5$"},
                       {.measured = {measured, 0.0078125}, .reference = 5, .margin = 0.125});
        ledger.compare({"4"}, {"six", "$6$"},
                       {.measured = {6, 0.0078125},
                        .reference = to_be_told_apart,
                        .margin = 0.125,
                        .asks = Asks::whether_apart});
        ledger.guide({"5"}, {"seven", "$7$"}, {.measured = {8, 0.0078125}, .reference = 7});
        return conclude(experiment, ledger, Macros("Demo"));
    };
    BOOST_TEST((concluded(5.02, 7) == Verdict::agrees));
    BOOST_TEST((concluded(5.125, 7) == Verdict::undecided));
    BOOST_TEST((concluded(5.02, 6) == Verdict::differs));
    BOOST_TEST((concluded(5.25, 7) == Verdict::differs));
    auto const text = [&](char const* name) { return text_of(directory.path / name); };
    BOOST_TEST(text("demo.csv").find("3,five,5.25,0.0078125,5,0,0.125,32,nan,differs") !=
               std::string::npos);
    BOOST_TEST(text("demo.tex").find("\\DemoVerdict}{differs}") != std::string::npos);
    BOOST_TEST(text("demo.tex").find("\\DemoLargestZ}{32}") != std::string::npos);
    BOOST_TEST(text("demo_table.tex").find("3 & $5$ & 5.2500(78) & 5 & 0.12 & $+32.0$ & differs") !=
               std::string::npos);
}
