#include "simulation/build_engine.hpp"

namespace clack {

namespace {

std::unique_ptr<Engine> build(System const& system, Method method, Precision precision,
                              Origin const& origin) {
    switch (precision) {
    case Precision::single_:
        return build_engine<float>(system, method, precision, origin);
    case Precision::double_:
        return build_engine<double>(system, method, precision, origin);
    case Precision::extended:
        return build_engine<long double>(system, method, precision, origin);
    default:
        return build_engine<quad>(system, method, precision, origin);
    }
}

std::size_t number_bytes(Precision precision) {
    switch (precision) {
    case Precision::single_:
        return sizeof(float);
    case Precision::double_:
        return sizeof(double);
    default:
        return sizeof(quad);
    }
}

} // namespace

std::unique_ptr<Engine> make_engine(System const& system, Method method, Precision precision,
                                    Start const& start) {
    return build(system, method, precision, {.start = &start, .checkpoint = nullptr});
}

std::unique_ptr<Engine> make_engine(System const& system, Method method, Precision precision,
                                    Checkpoint const& checkpoint) {
    return build(system, method, precision, {.start = nullptr, .checkpoint = &checkpoint});
}

std::size_t expected_bytes(System const& system, Method method, Precision precision) {
    ModelChoice const choice = choose_model(system, method, precision);
    std::size_t const number = number_bytes(precision);
    // Record and next event; then what a million balls on a lattice were measured to take at the
    // peak, and a fifth more, which a dense random start needs for a while.
    std::size_t per_ball = 11 * number + 69;
    if (system.boundary == Boundary::periodic) per_ball += 12;
    if (choice.search == SearchKind::cell_grid) per_ball += 25;
    if (choice.search == SearchKind::neighbour_list) per_ball += 77;
    if (choice.queue == QueueKind::calendar) per_ball += 22;
    constexpr std::size_t program = 32u << 20;
    return program + per_ball * static_cast<std::size_t>(system.count) / 5 * 6;
}

} // namespace clack
