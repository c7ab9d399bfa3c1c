#include "cli/law_check.hpp"

#include "observables/overlap.hpp"
#include "scenes/scene.hpp"
#include "state/errors.hpp"
#include "state/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace clack {

namespace {

/// Of the run's numbers as the file shows them: no finer than a double.
double unit_roundoff_of(TrajectoryReader const& file) {
    auto const& header = file.header();
    auto const scene = parse_scene(header.scene_text, header.scene_source);
    return scene.precision == Precision::single_ ? static_cast<double>(unit_roundoff<float>)
                                                 : unit_roundoff<double>;
}

/// The laws that a frame keeps by itself and in comparison with the first.
class FrameLaws {
public:
    FrameLaws(System const& system, double epoch_length, double unit_roundoff)
        : system_(system), epoch_length_(epoch_length), unit_roundoff_(unit_roundoff) {}

    void add(std::size_t number, Snapshot const& frame, Sample const& sample) {
        auto const here = [&](std::string const& what) {
            return fmt::format("{} in frame {} at t = {:.17g}", what, number, frame.time);
        };
        double const energy = 0.5 * system_.mass * squared_speeds(frame.velocities);
        Eigen::Vector3d const momentum = system_.mass * sum(frame.velocities);
        if (!first_) first_ = {energy, momentum};
        check_places(frame, here);
        check_motion(energy, momentum, sample, here);
        check_course(frame, sample, here);
        previous_ = sample;
    }

    std::vector<Verdict> verdicts() const {
        std::vector<Verdict> all{{"balls keep out of each other", overlap_},
                                 {"balls stay in the cube", inside_},
                                 {"energy stays", energy_}};
        if (system_.boundary == Boundary::periodic) all.push_back({"momentum stays", momentum_});
        all.push_back({"time goes on and counts grow", course_});
        return all;
    }

private:
    struct Motion {
        double energy;
        Eigen::Vector3d momentum;
    };

    static double squared_speeds(Eigen::Matrix3Xd const& velocities) {
        double total = 0;
        for (Eigen::Index i = 0; i < velocities.cols(); ++i) {
            total += velocities.col(i).squaredNorm();
        }
        return total;
    }
    static Eigen::Vector3d sum(Eigen::Matrix3Xd const& velocities) {
        Eigen::Vector3d total = Eigen::Vector3d::Zero();
        for (Eigen::Index i = 0; i < velocities.cols(); ++i) total += velocities.col(i);
        return total;
    }

    /// The same bound as the engine's own: a thousand roundings of a place and of a flight.
    void check_places(Snapshot const& frame, auto const& here) {
        double fastest = 0;
        for (Eigen::Index i = 0; i < frame.velocities.cols(); ++i) {
            fastest = std::max(fastest, frame.velocities.col(i).norm());
        }
        double const rounding =
            1024 * unit_roundoff_ * (system_.side + system_.diameter + 2 * fastest * epoch_length_);
        auto const overlap = deepest_overlap(system_, frame.positions);
        overlap_.note(overlap.depth * system_.diameter, rounding, [&] {
            return here(fmt::format("balls {} and {} overlap by {:.3g} diameters", overlap.first,
                                    overlap.second, overlap.depth));
        });
        auto const outside = farthest_outside(system_, frame.positions);
        inside_.note(outside.distance, rounding, [&] {
            return here(fmt::format("ball {} is {:.3g} outside", outside.ball, outside.distance));
        });
    }

    void check_motion(double energy, Eigen::Vector3d const& momentum, Sample const& sample,
                      auto const& here) {
        auto const count = static_cast<double>(system_.count);
        auto const& tallies = sample.tallies;
        double const collisions =
            static_cast<double>(tallies.ball_collisions + tallies.wall_collisions) / count;
        double const share = unit_roundoff_ * (1000 + 16 * collisions);
        energy_.note(std::abs(energy - first_->energy), share * first_->energy, [&] {
            return here(fmt::format("{:.17g} instead of {:.17g}", energy, first_->energy));
        });
        double const summation = unit_roundoff_ * (64 + count);
        energy_.note(std::abs(energy - sample.kinetic_energy), summation * energy, [&] {
            return here(fmt::format("the file says {:.17g}, the velocities {:.17g}",
                                    sample.kinetic_energy, energy));
        });
        // The sum of the sizes of all momenta is at most this.
        double const scale = std::sqrt(2 * system_.mass * count * first_->energy);
        momentum_.note((momentum - first_->momentum).norm(), share * scale, [&] {
            return here(fmt::format("changed by {:.3g}", (momentum - first_->momentum).norm()));
        });
    }

    void check_course(Snapshot const& frame, Sample const& sample, auto const& here) {
        auto const fail = [&](bool wrong, char const* what) {
            course_.note(wrong ? 2 : 0, 1, [&] { return here(what); });
        };
        fail(frame.ball_collisions != sample.tallies.ball_collisions,
             "step is not the number of collisions");
        if (!previous_) return;
        fail(!(frame.time > previous_->time), "time is not after the frame before");
        fail(sample.tallies.ball_collisions < previous_->tallies.ball_collisions ||
                 sample.tallies.wall_collisions < previous_->tallies.wall_collisions,
             "fewer collisions than in the frame before");
    }

    System system_;
    double epoch_length_, unit_roundoff_;
    std::optional<Motion> first_;
    std::optional<Sample> previous_;
    Departure overlap_, inside_, energy_, momentum_, course_;
};

/// The events in their order, up to where each frame stands.
class EventLaws {
public:
    EventLaws(TrajectoryReader const& file, EventReplay replay)
        : file_(file), replay_(std::move(replay)) {}

    void up_to_frame(std::size_t number, Snapshot const& frame, Sample const& sample) {
        auto const& tallies = sample.tallies;
        advance_to(tallies.ball_collisions + tallies.wall_collisions);
        bool const agree = replay_.ball_collisions() == tallies.ball_collisions &&
                           replay_.wall_collisions() == tallies.wall_collisions;
        counts_.note(agree ? 0 : 2, 1, [&] {
            return fmt::format("frame {} counts {} + {} collisions, the events {} + {}", number,
                               tallies.ball_collisions, tallies.wall_collisions,
                               replay_.ball_collisions(), replay_.wall_collisions());
        });
        if (agree && number > 0) replay_.add_frame(frame);
    }

    std::vector<Verdict> verdicts() {
        advance_to(file_.event_count());
        auto const& findings = replay_.findings();
        return {{"events come in order", findings.order},
                {"balls and walls touch when they collide", findings.contact},
                {"collisions exchange normal velocities alone", findings.exchange},
                {"events lead from frame to frame", findings.frames},
                {"no event is missing", counts_}};
    }

private:
    void advance_to(std::uint64_t event) {
        constexpr std::uint64_t batch = 1u << 16;
        auto const end = std::min<std::uint64_t>(event, file_.event_count());
        while (next_ < end) {
            auto const events = file_.events(next_, std::min(batch, end - next_));
            for (auto const& one : events) replay_.add_event(one);
            next_ += events.size();
        }
    }

    TrajectoryReader const& file_;
    EventReplay replay_;
    Departure counts_;
    std::uint64_t next_ = 0;
};

} // namespace

std::vector<Verdict> check_laws(TrajectoryReader const& file) {
    if (file.frame_count() == 0) {
        throw InputError(file.path() + ": holds no frame yet, its run is still equilibrating; "
                                       "resume it first");
    }
    auto const& system = file.header().system;
    double const epoch_length = file.header().epoch_length;
    double const roundoff = unit_roundoff_of(file);
    FrameLaws frames(system, epoch_length, roundoff);
    std::optional<EventLaws> events;
    if (file.header().events == Events::stored) {
        events.emplace(file, EventReplay(system, epoch_length, roundoff, file.snapshot(0)));
    }
    for (std::size_t number = 0; number < file.frame_count(); ++number) {
        auto const frame = file.snapshot(number);
        auto const sample = file.frame_sample(number);
        frames.add(number, frame, sample);
        if (events) events->up_to_frame(number, frame, sample);
    }
    auto verdicts = frames.verdicts();
    if (events) {
        for (auto& verdict : events->verdicts()) verdicts.push_back(std::move(verdict));
    }
    return verdicts;
}

} // namespace clack
