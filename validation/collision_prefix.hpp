#pragma once
// How many collisions soft and hard balls have in common before they part: the second half of
// trajectories_vs_lammps.

#include "validation/harness/experiment.hpp"
#include "validation/records/campaign.hpp"
#include "validation/soft_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>

namespace clack::validation::collision_prefix {

constexpr double steps_per_contact = 50; // rather a longer run than a more exact one
constexpr double looks_per_contact = 5;  // so that no contact is overlooked
constexpr double equilibration = 30;     // collisions per ball

/// What all jobs run.
inline std::string deck() { return reference::lammps_deck("lammps_cube.in"); }

/// One run from one start, long enough for the sequences to part.
struct StatePoint {
    double packing_fraction;
    std::int64_t count;
    double time;
    int replicates;
    std::vector<double> stiffnesses;

    System system() const {
        double const density = packing_fraction * 6 / std::numbers::pi;
        return {.side = std::cbrt(static_cast<double>(count) / density), .count = count};
    }
    std::string text() const {
        return fmt::format("prefix packing_fraction={} count={} time={} equilibration={} "
                           "steps_per_contact={} stiffnesses={} deck={:016x}",
                           packing_fraction, count, time, equilibration, steps_per_contact,
                           fmt::join(stiffnesses, ","), hash_of(deck()));
    }
};

inline std::vector<StatePoint> state_points(Profile const profile) {
    bool const full = profile == Profile::full;
    auto const ladder = [&](double const first, int const length) {
        std::vector<double> all;
        for (int k = 0; k < length; ++k) all.push_back(first * std::pow(8, k));
        return all;
    };
    int const replicates = full ? 20 : 3, length = full ? 5 : 4;
    return {{0.2, 100, full ? 4.0 : 2.5, replicates, ladder(2e4, length)},
            {0.4, 100, full ? 1.2 : 0.6, replicates, ladder(1.6e5, length)}};
}

/// The balls that each ball meets, in their order.
using Partners = std::vector<std::vector<std::int64_t>>;

inline Partners partners_of(std::vector<Meeting> const& meetings, std::int64_t const count) {
    Partners partners(static_cast<std::size_t>(count));
    for (Meeting const& meeting : meetings) {
        if (meeting.kind != CollisionKind::ball) continue;
        partners[static_cast<std::size_t>(meeting.first)].push_back(meeting.second);
        partners[static_cast<std::size_t>(meeting.second)].push_back(meeting.first);
    }
    return partners;
}

inline Partners partners_of(std::vector<reference::SeenCollision> const& seen,
                            std::int64_t const count) {
    Partners partners(static_cast<std::size_t>(count));
    for (auto const& [step, first, second] : seen) {
        partners[static_cast<std::size_t>(first)].push_back(second);
        partners[static_cast<std::size_t>(second)].push_back(first);
    }
    return partners;
}

/// Collisions at the beginning of the two lists that are the same, mean over the balls.
inline double matched(Partners const& one, Partners const& other) {
    double sum = 0;
    for (std::size_t ball = 0; ball < one.size(); ++ball) {
        auto const [end, ignored] = std::mismatch(one[ball].begin(), one[ball].end(),
                                                  other[ball].begin(), other[ball].end());
        sum += static_cast<double>(end - one[ball].begin());
    }
    return sum / static_cast<double>(one.size());
}

/// Collisions per ball in all, then for each stiffness those that LAMMPS has in common with hard
/// balls and with such whose diameter yields.
inline Measurement measure(StatePoint const& point, std::uint64_t const seed) {
    System const system = point.system();
    auto const segments = segments_from(system, equilibrated(system, equilibration, seed),
                                        point.time, 1, true_segment_engine);
    Segment const& hard = segments.front();
    SoftRuns const runs{system, point.stiffnesses, steps_per_contact, looks_per_contact};
    reference::LammpsFolder const folder;
    runs.run(folder, deck(), segments);
    Partners const of_hard = partners_of(hard.meetings, system.count);
    Measurement values{matched(of_hard, of_hard)};
    for (std::size_t k = 0; k < point.stiffnesses.size(); ++k) {
        auto const frames =
            reference::read_lammps_dump(folder / (SoftRuns::name(k, 0) + ".contacts"));
        Partners const soft = partners_of(reference::collisions_seen(frames), system.count);
        Segment const yielding =
            softened<SoftenedBalls>(system, hard, point.stiffnesses[k], steps_per_contact);
        values.push_back(matched(of_hard, soft));
        values.push_back(matched(partners_of(yielding.meetings, system.count), soft));
    }
    return values;
}

} // namespace clack::validation::collision_prefix
