#pragma once
// A sum that does not depend on the order of its terms.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace clack {

/// Adds up numbers that are not negative: exactly, as integers by magnitude, and rounded at the
/// end. So balls need not be visited by their permanent numbers, which in a large system are far
/// apart in memory. Room for 2^43 terms.
class OrderlessSum {
public:
    void add(double term) {
        auto const bits = std::bit_cast<std::uint64_t>(term);
        std::uint64_t const exponent = bits >> mantissa_bits;
        if (exponent >= not_finite) { // or negative
            invalid_ = true;
            return;
        }
        std::uint64_t const hidden = std::uint64_t{exponent > 0} << mantissa_bits;
        std::uint64_t const shift = exponent > 0 ? exponent - 1 : 0; // in units of the least number
        Wide const mantissa = (bits & ((std::uint64_t{1} << mantissa_bits) - 1)) | hidden;
        bins_[shift / bin_bits] += mantissa << (shift % bin_bits);
    }

    /// NaN where a term was negative or not finite.
    double value() const {
        if (invalid_) return std::numeric_limits<double>::quiet_NaN();
        constexpr int least_exponent = -1074;
        double sum = 0;
        for (std::size_t k = 0; k < bins_.size(); ++k)
            sum += std::ldexp(static_cast<double>(bins_[k]),
                              static_cast<int>(k * bin_bits) + least_exponent);
        return sum;
    }

private:
    __extension__ using Wide = unsigned __int128;
    static constexpr std::uint64_t mantissa_bits = 52, not_finite = 2047, bin_bits = 32;

    std::array<Wide, 64> bins_{};
    bool invalid_ = false;
};

} // namespace clack
