#pragma once
// A look at what another thread may be writing.

#include <type_traits>

namespace clack {

/// A value that was or is there. It orders nothing: good for hints, where any value will do.
template <class Item> Item glance(Item const& item) {
    static_assert(std::is_trivially_copyable_v<Item> && sizeof(Item) <= sizeof(void*));
    Item seen;
    __atomic_load(&item, &seen, __ATOMIC_RELAXED); // atomic_ref would ask the writer for the same
    return seen;
}

} // namespace clack
