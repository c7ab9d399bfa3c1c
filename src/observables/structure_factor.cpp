#include "observables/structure_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

namespace clack {

StructureFactor::StructureFactor(System const& system, int const largest_square) : system_(system) {
    if (system.boundary != Boundary::periodic || largest_square < 1) {
        throw std::invalid_argument(
            fmt::format("structure factor of waves with |n|^2 up to {}: needs a periodic cube and "
                        "at least 1",
                        largest_square));
    }
    while ((longest_ + 1) * (longest_ + 1) <= largest_square) ++longest_;
    for (int square = 1; square <= largest_square; ++square) {
        Shell shell{square, {}};
        for (int x = -longest_; x <= longest_; ++x)
            for (int y = -longest_; y <= longest_; ++y)
                for (int z = -longest_; z <= longest_; ++z) {
                    // of n and -n the one whose last component that is not zero is positive
                    bool const one_of_two = z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
                    if (one_of_two && x * x + y * y + z * z == square)
                        shell.waves.emplace_back(x, y, z);
                }
        if (!shell.waves.empty()) shells_.push_back(shell);
    }
}

void StructureFactor::add(Snapshot const& snapshot) {
    using Phases = Eigen::ArrayXcd;
    // exp(2 pi i n x / side) for each axis and n = 0 ... longest
    std::vector<std::vector<Phases>> phases(3);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Eigen::ArrayXd const angle = snapshot.positions.row(axis).transpose().array() *
                                     (2 * std::numbers::pi / system_.side);
        Phases first(angle.size());
        first.real() = angle.cos();
        first.imag() = angle.sin();
        auto& powers = phases[static_cast<std::size_t>(axis)];
        powers.push_back(Phases::Ones(angle.size()));
        for (int n = 1; n <= longest_; ++n) powers.emplace_back(powers.back() * first);
    }
    auto const phase = [&](std::size_t const axis, int const n) -> Phases {
        Phases const& positive = phases[axis][static_cast<std::size_t>(std::abs(n))];
        return n < 0 ? positive.conjugate().eval() : positive;
    };
    for (Shell& shell : shells_)
        for (Eigen::Vector3i const& n : shell.waves)
            shell.sum += std::norm((phase(0, n[0]) * phase(1, n[1]) * phase(2, n[2])).sum());
    ++snapshots_;
}

std::vector<double> StructureFactor::wave_numbers() const {
    std::vector<double> numbers;
    for (Shell const& shell : shells_)
        numbers.push_back(2 * std::numbers::pi / system_.side * std::sqrt(shell.square));
    return numbers;
}

std::vector<double> StructureFactor::values() const {
    std::vector<double> values;
    for (Shell const& shell : shells_) {
        double const terms = static_cast<double>(shell.waves.size()) * std::max(snapshots_, 1);
        values.push_back(shell.sum / (terms * static_cast<double>(system_.count)));
    }
    return values;
}

} // namespace clack
