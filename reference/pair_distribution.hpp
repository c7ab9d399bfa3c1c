#pragma once
// g(r) and S(k) of the infinite fluid of equal hard balls. Unit: diameter = 1.

#include <vector>

namespace clack::reference {

/// Percus and Yevick's closure, solved exactly by Wertheim and Thiele. Right to the first order in
/// density; its contact value falls short by 13 % at freezing.
class PercusYevick {
public:
    ///   packing_fraction   in (0, 0.6)
    ///   reach              the largest distance that will be asked for
    /// g is found from Baxter's form by Perram's marching in steps of 1/400, right to 1e-5.
    /// Throws std::invalid_argument outside these limits.
    /// Source: R. J. Baxter, Aust. J. Phys. 21, 563 (1968); J. W. Perram, Mol. Phys. 30, 1505
    /// (1975).
    PercusYevick(double packing_fraction, double reach);

    /// g at a distance of 1 up to the reach; at 1 the contact value. Throws std::invalid_argument
    /// beyond the reach, gives 0 within the diameter.
    double radial_distribution(double distance) const;
    /// S at a wave number above 0 [1 / diameter].
    double structure_factor(double wave_number) const;

private:
    double packing_fraction_, reach_;
    std::vector<double> values_; // r (g(r) - 1) from r = 1 on
};

/// Percus and Yevick's g mended by Verlet and Weis: taken at a slightly smaller density and
/// diameter, with a damped wave that brings the contact value to a given one. Good to about 1 %
/// of the contact value.
/// Source: L. Verlet, J.-J. Weis, Phys. Rev. A 5, 939 (1972).
class VerletWeis {
public:
    ///   contact_value   g(1), (Z - 1) / (4 packing_fraction)
    /// Other arguments and refusals as PercusYevick.
    VerletWeis(double packing_fraction, double contact_value, double reach);

    double radial_distribution(double distance) const;

private:
    double width_; // of the balls of the mended closure
    PercusYevick closure_;
    double amplitude_, wave_number_;
};

} // namespace clack::reference
