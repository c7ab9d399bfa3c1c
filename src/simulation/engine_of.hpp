#pragma once
// One simulation behind the interface of engine.hpp.

#include "simulation/engine.hpp"
#include "simulation/sequence_hash.hpp"
#include "simulation/simulation.hpp"

#include <optional>

namespace clack {

template <class Simulation> class EngineOf final : public Engine {
    using Real = typename Simulation::Number;

public:
    template <class State>
    EngineOf(State state, ModelDescription model)
        : simulation_(std::move(state)), model_(std::move(model)) {}

    Stop advance(Goal const& goal, CollisionObserver* observer) override {
        if (!observer && !hash_) return simulation_.advance(goal, NoObserver{});
        return simulation_.advance(goal, [&](Collision<Real> const& collision) {
            if (hash_) hash_->add(collision);
            if (observer) (*observer)(collision.template cast<double>());
        });
    }

    void start_clock() override { simulation_.start_clock(); }
    void hash_collisions() override {
        if (!hash_) hash_.emplace();
    }
    void resume_hash(std::uint64_t hash) { hash_ = SequenceHash(hash); }

    double time() const override { return state().clock.time(); }
    Tallies const& tallies() const override { return state().tallies; }
    std::uint64_t hash() const override { return hash_ ? hash_->value() : 0; }
    double kinetic_energy() const override { return static_cast<double>(state().kinetic_energy()); }
    Eigen::Vector3d momentum() const override { return state().momentum().template cast<double>(); }
    Snapshot snapshot() const override { return state().snapshot(); }
    Checkpoint checkpoint() const override {
        Checkpoint kept = state().checkpoint();
        kept.hash = hash();
        return kept;
    }
    System const& system() const override { return state().system; }
    ModelDescription model() const override { return model_; }
    std::size_t bytes() const override { return simulation_.bytes(); }

private:
    auto const& state() const { return simulation_.state(); }

    Simulation simulation_;
    ModelDescription model_;
    std::optional<SequenceHash> hash_;
};

} // namespace clack
