#pragma once
// A look at what another thread may be writing.

#include <type_traits>

namespace clack {

/// A value that was or is there. It orders nothing: good for hints, where any value will do.
/// Numbers wider than a register are only in runs that one thread makes.
template <class Item> Item glance(Item const& item) {
    if constexpr (sizeof(Item) <= sizeof(void*)) {
        static_assert(std::is_trivially_copyable_v<Item>);
        Item seen;
        __atomic_load(&item, &seen, __ATOMIC_RELAXED); // atomic_ref asks the writer for the same
        return seen;
    } else {
        return item;
    }
}

} // namespace clack
