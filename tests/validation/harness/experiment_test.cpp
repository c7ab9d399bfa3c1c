#include "reference/published_table.hpp"
#include "state/errors.hpp"
#include "validation/harness/experiment.hpp"
#include "validation/harness/findings.hpp"

#include "tests/validation/harness/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace clack;
using namespace clack::validation;

namespace {

Question const question{"demo", "does two and two make four?", "none: it is arithmetic"};

int run_with(std::vector<char const*> arguments, std::function<Verdict(Experiment&)> const& ask) {
    arguments.insert(arguments.begin(), "demo");
    return run(static_cast<int>(arguments.size()), arguments.data(), question, ask);
}

Verdict never(Experiment&) { throw std::logic_error("must not be asked"); }

} // namespace

BOOST_AUTO_TEST_CASE(verdict_is_the_exit_code) {
    TemporaryDirectory const directory("experiment");
    std::vector<char const*> const there{"-o", directory.path.c_str()};
    BOOST_TEST(run_with(there, [](Experiment&) { return Verdict::agrees; }) == 0);
    BOOST_TEST(run_with(there, [](Experiment&) { return Verdict::differs; }) == 1);
    BOOST_TEST(run_with(there, [](Experiment&) { return Verdict::undecided; }) == 1);
    BOOST_TEST(run_with(there, [](Experiment&) -> Verdict { throw LawBroken("overlap"); }) == 1);
    BOOST_TEST(run_with(there, [](Experiment&) -> Verdict { throw InputError("no"); }) == 2);
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
          "# program: ", "# compiler: ", "# machine: ", "# seeds: ", "# margin: none"})
        BOOST_TEST(csv.find(line) != std::string::npos, line);
    reference::PublishedTable const table(directory.path / "demo_again.csv");
    BOOST_TEST(table.column("doubled").at(0) == 4);
    BOOST_TEST(text_of(directory.path / "demo.tex").find("\\newcommand{\\DemoSum}{4}") !=
               std::string::npos);
    BOOST_TEST(text_of(directory.path / "demo_table.tex").starts_with("\\begin{tabular}"));
    BOOST_TEST(text_of(directory.path / "demo_verdict.tex")
                   .starts_with("\\texttt{demo} & 0 & none & -- & agrees & "));
}

BOOST_AUTO_TEST_CASE(findings_are_judged_together_and_left_behind) {
    TemporaryDirectory const directory("experiment");
    auto const concluded = [&](double const measured, Verdict const required) {
        Options options;
        options.directory = directory.path;
        Experiment experiment(question, options);
        Findings findings("sum", "$s$");
        findings.add(
            {"four", "$4$", 2, {.measured = {4, 0.0078125}, .reference = 4, .margin = 0.125}});
        findings.add({"five",
                      "$5$",
                      3,
                      {.measured = {measured, 0.0078125}, .reference = 5, .margin = 0.125}});
        findings.require(required);
        return findings.conclude(experiment, "Demo");
    };
    BOOST_TEST((concluded(5.02, Verdict::agrees) == Verdict::agrees));
    BOOST_TEST((concluded(5.125, Verdict::agrees) == Verdict::undecided));
    BOOST_TEST((concluded(5.02, Verdict::differs) == Verdict::differs));
    BOOST_TEST((concluded(5.25, Verdict::agrees) == Verdict::differs));
    auto const text = [&](char const* name) {
        std::ifstream file(directory.path / name);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    BOOST_TEST(text("demo.csv").find("five,3,5.25,0.0078125,5,0,0.125,32,differs") !=
               std::string::npos);
    BOOST_TEST(text("demo.tex").find("\\DemoVerdict}{differs}") != std::string::npos);
    BOOST_TEST(text("demo_table.tex").find("$5$ & 3 & $5.2500(78)$") != std::string::npos);
}
