// Judges what another program measured of hard balls in a periodic cube: by the same theory, with
// the same verdicts as clack.

#include "reference/published_table.hpp"
#include "validation/harness/ledger.hpp"
#include "validation/periodic_fluid.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <map>

using namespace clack::validation;

namespace {

Ledger ledger_of(std::string const& quantity, std::string const& path, double const margin) {
    clack::reference::PublishedTable const table(path);
    auto const &eta = table.column("packing_fraction"), &count = table.column("count"),
               &value = table.column("value");
    std::map<std::pair<double, std::int64_t>, std::vector<double>> runs;
    for (std::size_t row = 0; row < table.row_count(); ++row)
        runs[{eta[row], std::llround(count[row])}].push_back(value[row]);
    Ledger ledger({{"packing_fraction", ""}, {"count", ""}});
    for (auto const& [point, values] : runs) {
        constexpr double first_crystal = 0.545; // the fluid freezes at 0.494
        constexpr double theory_error = 3e-4;   // as large as it is anywhere
        PeriodicFluid fluid{.packing_fraction = point.first, .count = point.second};
        if (point.first >= first_crystal) fluid.arrangement = clack::Arrangement::fcc;
        bool const is_z = quantity == "Z";
        double const part = is_z ? fluid.collisional() : fluid.collision_rate();
        ledger.compare({cell(point.first), cell(point.second)}, {quantity, ""},
                       {.measured = mean_of(values),
                        .reference = is_z ? fluid.expected() : part,
                        .reference_error = theory_error * part,
                        .margin = margin / 100 * part});
    }
    ledger.judge();
    return ledger;
}

} // namespace

int main(int argc, char** argv) {
    std::string quantity, path;
    double margin = 0.5;
    CLI::App app("Does what another program measured of hard balls agree with theory?", "judge");
    app.add_option("QUANTITY", quantity,
                   "Z = P V/(N kT), or collision_rate of a ball at kT = m = 1")
        ->required()
        ->check(CLI::IsMember({"Z", "collision_rate"}));
    app.add_option("FILE", path, "packing_fraction,count,value: a row an independent run")
        ->required();
    app.add_option("--margin", margin, "per cent of the rate, or of Z - 1, that would not matter")
        ->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        Ledger const ledger = ledger_of(quantity, path, margin);
        std::cout << ledger.text() << name_of(ledger.verdict()) << '\n';
        return ledger.verdict() == Verdict::agrees ? 0 : 1;
    } catch (std::exception const& mistake) { // also what theory and statistics refuse
        std::cerr << "judge: " << mistake.what() << '\n';
        return 2;
    }
}
