// What the experiment catches, with the settings and seeds of its quick profile. Skipped where
// LAMMPS is not installed.

#include "validation/trajectories_vs_lammps.hpp"

#include "tests/reference/needs_lammps.hpp"
#include "validation/collision_prefix.hpp"
#include "validation/mutants/mutant_models.hpp"

#include <boost/test/unit_test.hpp>

using namespace clack;
using namespace clack::validation;
using namespace clack::validation::trajectories_vs_lammps;

namespace {

/// Balls too narrow by 0.1 %: too wide ones could not start where the others do.
template <class Real> struct NarrowerBalls : ElasticBalls<Real> {
    static System narrowed(System system) {
        system.diameter *= 0.999;
        return system;
    }
    explicit NarrowerBalls(System const& system) : ElasticBalls<Real>(narrowed(system)) {}
};

/// Impulses too weak by 1e-4: seen only where nothing of first order hides it.
template <class Real> struct WeakSoftenedBalls : SoftenedBalls<Real> {
    using SoftenedBalls<Real>::SoftenedBalls;
    static constexpr bool keeps_energy = false;

    Vector3<Real> collide(Vector3<Real>& velocity_i, Vector3<Real>& velocity_j,
                          Vector3<Real> const& separation, std::uint64_t /*collision*/) const {
        return exchange_normal_velocities(velocity_i, velocity_j, separation,
                                          static_cast<Real>(1 - 1e-4));
    }
};

/// The ledger of the smallest state point, judged as one of all.
Ledger ledger_with(Engines const& engines) {
    auto const points = state_points(Profile::quick);
    Measured measured{points.front(), {}};
    for (int replicate = 0; replicate < measured.point.replicates; ++replicate) {
        std::uint64_t const seed =
            seed_of("trajectories_vs_lammps", measured.point.text(), replicate);
        measured.replicates.push_back(measure(measured.point, seed, engines));
    }
    Ledger ledger({{"packing_fraction", ""}, {"count", ""}});
    enter(ledger, measured);
    for (Value const value : {plain_beyond, softened_beyond})
        enter_beyond(ledger, {measured}, measured.point.packing_fraction, value);
    ledger.judge({.false_alarm = risks.false_alarm / static_cast<double>(points.size())});
    BOOST_TEST_MESSAGE(ledger.text());
    return ledger;
}

/// Whether a quantity, at any stiffness, differs.
bool is_caught_by(Ledger const& ledger, std::string const& quantity) {
    auto const& all = ledger.entries();
    return std::any_of(all.begin(), all.end(), [&](Entry const& entry) {
        return entry.quantity.name.starts_with(quantity) && entry.verdict == Verdict::differs;
    });
}

template <template <class> class Model> Engines hard_engine() {
    return {.hard = [](System const& system, Start const& start) {
        return mutants::make<WalledCube, Model>(system, start);
    }};
}

} // namespace

BOOST_AUTO_TEST_CASE(true_engine_passes, *NeedsLammps()) {
    BOOST_TEST((ledger_with({}).verdict() == Verdict::agrees));
}

BOOST_AUTO_TEST_CASE(narrower_balls_do_not_pass, *NeedsLammps()) {
    Ledger const ledger = ledger_with(hard_engine<NarrowerBalls>());
    BOOST_TEST((ledger.verdict() == Verdict::differs));
    BOOST_TEST(is_caught_by(ledger, "slope"));
    BOOST_TEST(is_caught_by(ledger, "Richardson"));
}

/// The sharpest of the gates sees what the others cannot.
BOOST_AUTO_TEST_CASE(weaker_impulses_of_yielding_balls_do_not_pass, *NeedsLammps()) {
    Ledger const ledger = ledger_with({.yielding = softened<WeakSoftenedBalls>});
    BOOST_TEST((ledger.verdict() == Verdict::differs));
    BOOST_TEST(is_caught_by(ledger, "beyond 1e-5; softened"));
    BOOST_TEST(!is_caught_by(ledger, "slope"));
}

BOOST_AUTO_TEST_CASE(sequences_match_up_to_their_first_difference) {
    using collision_prefix::Partners;
    Partners const one{{1, 2, 3}, {5, 5}, {}}, other{{1, 2, 4, 3}, {5}, {7}};
    BOOST_TEST(collision_prefix::matched(one, one) == 5.0 / 3);
    BOOST_TEST(collision_prefix::matched(one, other) == (2 + 1 + 0) / 3.0);
    Partners const seen = collision_prefix::partners_of({{10, 0, 2}, {20, 1, 2}}, 3);
    BOOST_TEST((seen == Partners{{2}, {2}, {0, 1}}));
}
