#pragma once
// Large arrays on large pages: a million balls touch more pages than a processor remembers.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sys/mman.h>

namespace clack {

/// Makes room for so many items, on huge pages where the system has them and the room is worth it:
/// before anything is written there, or it would come too late.
template <class Item> void reserve_large(std::vector<Item>& items, std::size_t count) {
    if (count <= items.capacity()) return;
    items.reserve(count);
    constexpr std::size_t page = std::size_t{1} << 21;
    auto* const bytes = reinterpret_cast<char*>(items.data());
    std::size_t const before = (page - reinterpret_cast<std::uintptr_t>(bytes) % page) % page;
    std::size_t const room = items.capacity() * sizeof(Item);
    // Advice that is refused costs nothing but the speed.
    if (items.empty() && room > before + page)
        (void)madvise(bytes + before, (room - before) / page * page, MADV_HUGEPAGE);
}

/// So many items on huge pages.
template <class Item> std::vector<Item> large_vector(std::size_t count, Item const& item = Item{}) {
    std::vector<Item> items;
    reserve_large(items, count);
    items.resize(count, item);
    return items;
}

} // namespace clack
