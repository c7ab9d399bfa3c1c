#pragma once
// How fast it goes, in truth.

#include <chrono>
#include <cstdint>
#include <optional>

namespace clack::view {

/// Rates over the last half second or so, from what was reached and when.
class Meter {
public:
    using Clock = std::chrono::steady_clock;

    struct Rates {
        double speed = 0; // simulated time in a second
        double collisions_per_second = 0;
        double engine_share = 0; // of the time, spent in the engine
    };

    /// Where the balls stand: their time, and the collisions until then.
    struct Reached {
        double time = 0;
        std::uint64_t collisions = 0;
    };

    void begin(Clock::time_point now, Reached const& reached) {
        begin_ = now;
        from_ = reached;
        engine_seconds_ = 0;
    }
    void add_engine_seconds(double seconds) { engine_seconds_ += seconds; }

    /// The rates since the last time that there were some, when that is long enough ago. Time that
    /// went back, because somebody asked for it, is no speed.
    std::optional<Rates> read(Clock::time_point now, Reached const& reached) {
        constexpr double span = 0.5; // [s]
        double const passed = std::chrono::duration<double>(now - begin_).count();
        if (passed < span) return std::nullopt;
        Rates rates;
        if (reached.time > from_.time) rates.speed = (reached.time - from_.time) / passed;
        if (reached.collisions > from_.collisions)
            rates.collisions_per_second =
                static_cast<double>(reached.collisions - from_.collisions) / passed;
        rates.engine_share = engine_seconds_ / passed;
        begin(now, reached);
        return rates;
    }

private:
    Clock::time_point begin_ = Clock::now();
    Reached from_;
    double engine_seconds_ = 0;
};

} // namespace clack::view
