#include "reference/textbook_engines.hpp"

#include "neighbours/cell_grid.hpp"
#include "neighbours/every_pair.hpp"
#include "scheduling/collision_table.hpp"
#include "simulation/engine_of.hpp"
#include "simulation/model_choice.hpp"

#include <cmath>
#include <limits>

namespace clack::reference {

namespace {

/// The root of the schoolbook: near-equal numbers are subtracted, in the discriminant where the
/// balls are far apart, and under and beside the root where they are near.
template <class Real> struct NaiveRoot : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    template <class Number> Number contact_time(Pair<Number> const& p) const {
        Number const zero{};
        Number const never = zero + std::numeric_limits<Real>::quiet_NaN();
        Number const a = p.vx * p.vx + p.vy * p.vy + p.vz * p.vz;
        Number const b = p.x * p.vx + p.y * p.vy + p.z * p.vz;
        Number const c = p.x * p.x + p.y * p.y + p.z * p.z - this->squared;
        Number const disc = b * b - a * c;
        Number const wait = (zero - b - square_root(select(disc < zero, zero, disc))) / a;
        Number const at = p.time + select(wait > zero, wait, zero); // an overlap collides now
        return select(b < zero, select(disc < zero, never, at), never);
    }
};

/// Guards against colliding again and again by forgetting all contacts that are not ahead.
template <class Real> struct ZeroIsNever : ElasticBalls<Real> {
    using ElasticBalls<Real>::ElasticBalls;
    template <class Number> Number contact_time(Pair<Number> const& p) const {
        Number const never = Number{} + std::numeric_limits<Real>::quiet_NaN();
        Number const when = ElasticBalls<Real>::contact_time(p);
        return select(when > p.time, when, never);
    }
};

/// Every pair but the one that has collided last, as long as neither has met anything else. A
/// collision writes two records at one moment, by which it is recognised.
template <class Real, class Container>
class EveryPairButTheLast : public EveryPair<Real, Container> {
    using Base = EveryPair<Real, Container>;

public:
    EveryPairButTheLast(System const& system, Container const& cube)
        : Base(system, cube), last_(static_cast<std::size_t>(system.count), no_ball),
          written_(last_.size(), 0) {}

    void rebuild(std::vector<Ball<Real>> const& balls, Real now) {
        balls_ = &balls;
        for (std::size_t i = 0; i < balls.size(); ++i) written_[i] = balls[i].time;
        Base::rebuild(balls, now);
    }

    std::span<std::int32_t const> candidates(std::int32_t ball) {
        recall(ball);
        auto const all = Base::candidates(ball);
        kept_.assign(all.begin(), all.end());
        std::int32_t const other = last_[index(ball)];
        if (other == no_ball || last_[index(other)] != ball) return kept_;
        std::replace(kept_.begin(), kept_.end(), other, ball);
        return kept_;
    }

    std::span<std::int32_t const> refresh(std::vector<Ball<Real>> const&, std::int32_t ball, Real) {
        return candidates(ball);
    }

private:
    static std::size_t index(std::int32_t ball) { return static_cast<std::size_t>(ball); }

    /// Whom a ball whose record is new has met: the other new one, or a wall.
    void recall(std::int32_t ball) {
        Real const time = (*balls_)[index(ball)].time;
        if (time == written_[index(ball)]) return;
        std::int32_t partner = no_ball;
        for (std::size_t j = 0; j < balls_->size(); ++j)
            if (j != index(ball) && (*balls_)[j].time == time && written_[j] != time)
                partner = static_cast<std::int32_t>(j);
        written_[index(ball)] = time;
        last_[index(ball)] = partner;
        if (partner == no_ball) return;
        written_[index(partner)] = time;
        last_[index(partner)] = ball;
    }

    std::vector<Ball<Real>> const* balls_ = nullptr;
    std::vector<std::int32_t> last_, kept_;
    std::vector<Real> written_; // when the record was, that `last_` is about
};

/// Cells into which a ball is put by its coordinate whenever it is asked for. At the moment at
/// which it should cross a face, rounding has left half of all balls short of it.
template <class Real, class Container> class CellsByFloor {
public:
    CellsByFloor(System const& system, Container const& cube)
        : cube_(cube), lattice_(system, cube, CellLattice<Real>::reach(system), 0.6, 5),
          bins_(Container::boundary, lattice_.per_side, static_cast<std::size_t>(system.count)) {}

    void rebuild(std::vector<Ball<Real>> const& balls, Real now) {
        bins_.clear();
        for (std::size_t i = 0; i < balls.size(); ++i)
            bins_.insert(static_cast<std::int32_t>(i), lattice_.cell_at(place_of(balls[i], now)));
    }

    void settle(std::vector<Ball<Real>> const&, std::int32_t) {}

    std::span<std::int32_t const> candidates(std::int32_t ball) {
        found_.clear();
        bins_.collect_around(bins_.cell_of(ball), found_);
        found_.template pad<lane_count>(ball);
        return {found_.begin(), found_.size()};
    }

    Real expiry(std::vector<Ball<Real>> const& balls, std::int32_t ball, Real now) const {
        Ball<Real> const& record = balls[static_cast<std::size_t>(ball)];
        Vector3<Real> const place = place_of(record, now);
        Cell const cell = lattice_.cell_at(place);
        Real first = infinity<Real>;
        for (int d = 0; d < 3; ++d) {
            Real const v = record.velocity[d];
            std::int32_t const ahead = cell[static_cast<std::size_t>(d)] + (v > 0 ? 1 : 0);
            bool const outer = ahead == 0 || ahead == lattice_.per_side;
            if (v == 0 || (outer && Container::boundary == Boundary::walls)) continue;
            Real const face = lattice_.origin + static_cast<Real>(ahead) * lattice_.side;
            first = std::min(first, std::max<Real>(0, (face - place[d]) / v));
        }
        return now + first;
    }

    std::span<std::int32_t const> refresh(std::vector<Ball<Real>> const& balls, std::int32_t ball,
                                          Real now) {
        bins_.remove(ball);
        bins_.insert(ball, lattice_.cell_at(place_of(balls[static_cast<std::size_t>(ball)], now)));
        return candidates(ball);
    }

    std::size_t bytes() const { return bins_.bytes() + found_.bytes(); }

private:
    Vector3<Real> place_of(Ball<Real> const& ball, Real now) const {
        Vector3<Real> place = ball.position(now);
        cube_.wrap(place);
        return place;
    }

    Container cube_;
    CellLattice<Real> lattice_;
    CellBins<3> bins_;
    BallBuffer found_;
};

template <template <class> class Container, template <class, class> class Search,
          template <class> class Model>
std::unique_ptr<Engine> assemble(System const& system, Checkpoint const& checkpoint) {
    using Built = EngineOf<Simulation<double, Container, Search, CollisionTable, Model>>;
    return std::make_unique<Built>(BallState<double, Container<double>>(system, checkpoint),
                                   ModelDescription{});
}

template <template <class, class> class Search, template <class> class Model = ElasticBalls>
std::unique_ptr<Engine> assemble_in_its_cube(System const& system, Checkpoint const& checkpoint) {
    return system.boundary == Boundary::walls
               ? assemble<WalledCube, Search, Model>(system, checkpoint)
               : assemble<PeriodicCube, Search, Model>(system, checkpoint);
}

/// The same moment by a clock whose one epoch lasts for ever.
Checkpoint by_absolute_time(Checkpoint checkpoint) {
    double const begin = static_cast<double>(checkpoint.epoch) * checkpoint.epoch_length;
    checkpoint.epoch = 0;
    checkpoint.epoch_length = 0x1p100;
    checkpoint.offset.front() += begin;
    constexpr std::size_t record = 7;
    for (std::size_t k = record - 1; k < checkpoint.records.size(); k += record)
        checkpoint.records[k] += begin;
    return checkpoint;
}

} // namespace

std::unique_ptr<Engine> make_textbook_engine(Textbook const rule, System const& system,
                                             Checkpoint const& checkpoint) {
    switch (rule) {
    case Textbook::naive_root:
        return assemble_in_its_cube<EveryPair, NaiveRoot>(system, checkpoint);
    case Textbook::zero_is_never:
        return assemble_in_its_cube<EveryPair, ZeroIsNever>(system, checkpoint);
    case Textbook::not_the_same:
        return assemble_in_its_cube<EveryPairButTheLast>(system, checkpoint);
    case Textbook::absolute_time:
        return make_engine(system, Method::table, Precision::double_, by_absolute_time(checkpoint));
    default:
        return assemble_in_its_cube<CellsByFloor>(system, checkpoint);
    }
}

} // namespace clack::reference
