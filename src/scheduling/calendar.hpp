#pragma once
// A queue of constant cost: a ring of time buckets, of which one is open and sorted.
// G. Paul, J. Comput. Phys. 221, 615 (2007); B. D. Lubachevsky, J. Comput. Phys. 94, 255 (1991).

#include "scheduling/open_bucket.hpp"
#include "state/chained_bins.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace clack {

/// A ball is filed under the bucket of its next event's time and never searched or taken out: when
/// the event changes it is filed again, and an entry that no longer holds is dropped when its
/// bucket is opened. The buckets form a ring; an entry of a later revolution goes back to its
/// place.
template <class Real> class Calendar {
public:
    static constexpr Staleness staleness = Staleness::found;

    explicit Calendar(std::size_t count) : looks_ahead_(count >= looks_ahead_from) {
        std::size_t buckets = 4;
        while (balls_per_bucket * buckets < 2 * count) buckets *= 2;
        mask_ = static_cast<std::int64_t>(buckets) - 1;
    }

    void rebuild(NextEvents<Real> const& next, Real now) {
        ring_.reset(static_cast<std::size_t>(mask_) + 1);
        bucket_.clear();
        base_ = now;
        inverse_width_ = 1 / bucket_width(next, now);
        open_ = 0;
        for (std::int32_t ball = 0; ball < static_cast<std::int32_t>(next.size()); ++ball)
            file(next, ball);
    }

    void update(NextEvents<Real> const& next, std::int32_t ball) { file(next, ball); }

    std::int32_t earliest(NextEvents<Real> const& next) {
        if (looks_ahead_ && bucket_.size() < events_ahead) open_one_more(next);
        for (;;) {
            std::int32_t const first = bucket_.earliest(next);
            if (first != no_event) return first;
            if (!open_next_bucket(next)) return no_event;
        }
    }

    /// Whether there are so many balls that it pays to know a few events in advance, for the
    /// memory.
    bool looks_ahead() const { return looks_ahead_; }
    /// The ball of the event that is so many places behind the first, if it is known yet.
    std::int32_t upcoming(std::size_t places) const { return bucket_.upcoming(places); }

    std::size_t bytes() const { return ring_.bytes() + bucket_.bytes(); }

private:
    static constexpr std::size_t looks_ahead_from = 65'536, events_ahead = 4;
    static constexpr std::size_t balls_per_bucket = 4; // measured flat between two and eight

    /// As if all waited equally long.
    static Real bucket_width(NextEvents<Real> const& next, Real now) {
        Real sum = 0;
        Real waiting = 0;
        for (std::int32_t ball = 0; ball < static_cast<std::int32_t>(next.size()); ++ball) {
            Real const time = next[ball].time();
            if (!(time < infinity<Real>)) continue;
            sum += time - now;
            waiting += 1;
        }
        Real const width = static_cast<Real>(balls_per_bucket) * sum / (waiting * waiting);
        return width > 0 && width < infinity<Real> ? width : Real(1);
    }

    /// Buckets since `base_`; rounding in the product is monotonic, so order between buckets holds.
    std::int64_t bucket_at(Real time) const {
        Real const index = (time - base_) * inverse_width_;
        Real const far = static_cast<Real>(0x1p62);
        return index < far ? static_cast<std::int64_t>(index) : static_cast<std::int64_t>(0x1p62);
    }

    void file(NextEvents<Real> const& next, std::int32_t ball) {
        Real const time = next[ball].time();
        if (!(time < infinity<Real>)) return;
        std::int64_t const bucket = bucket_at(time);
        if (bucket > open_) {
            ring_.insert(static_cast<std::size_t>(bucket & mask_), ball);
        } else {
            bucket_.insert(next, ball);
        }
    }

    void open_one_more(NextEvents<Real> const& next) {
        ++open_;
        open(next);
    }

    /// Opens the next bucket that holds an event; false when there is none at all.
    bool open_next_bucket(NextEvents<Real> const& next) {
        std::int64_t const last = open_ + mask_ + 1;
        while (open_ < last) {
            ++open_;
            open(next);
            if (!bucket_.empty()) return true;
        }
        // A whole revolution without an event: go where the next one is.
        std::int64_t first = std::numeric_limits<std::int64_t>::max();
        for (std::int32_t ball = 0; ball < static_cast<std::int32_t>(next.size()); ++ball) {
            if (next[ball].time() < infinity<Real>)
                first = std::min(first, bucket_at(next[ball].time()));
        }
        if (first == std::numeric_limits<std::int64_t>::max()) return false;
        open_ = first;
        open(next);
        return true;
    }

    void open(NextEvents<Real> const& next) {
        fetch_following(next);
        auto const slot = static_cast<std::size_t>(open_ & mask_);
        if (ring_.block(slot).count == 0) return;
        ring_.drain(slot, [&](std::int32_t ball) {
            Real const time = next[ball].time();
            if (!(time < infinity<Real>)) return;
            std::int64_t const bucket = bucket_at(time);
            if (bucket == open_) {
                bucket_.insert(next, ball);
            } else if (bucket > open_ && static_cast<std::size_t>(bucket & mask_) == slot) {
                ring_.insert(slot, ball);
            }
        });
    }

    /// Asks the memory for what the next buckets to be opened will read.
    void fetch_following(NextEvents<Real> const& next) const {
        __builtin_prefetch(&ring_.block(static_cast<std::size_t>((open_ + 2) & mask_)));
        auto const& block = ring_.block(static_cast<std::size_t>((open_ + 1) & mask_));
        for (std::int32_t k = 0; k < block.count; ++k)
            __builtin_prefetch(&next[block.ball[static_cast<std::size_t>(k)]]);
    }

    bool looks_ahead_;
    ChainedBins<14> ring_; // a block is a cache line
    std::int64_t mask_;    // buckets in the ring, a power of two, less one
    OpenBucket<Real> bucket_;
    Real base_ = 0, inverse_width_ = 1;
    std::int64_t open_ = 0;
};

} // namespace clack
