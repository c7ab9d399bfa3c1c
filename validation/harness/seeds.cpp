#include "validation/harness/seeds.hpp"

#include <fmt/format.h>

namespace clack::validation {

namespace {

std::uint64_t avalanche(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
}

} // namespace

std::uint64_t hash_of(std::string_view const text) {
    std::uint64_t bits = 0xcbf29ce484222325u;
    for (char const character : text) {
        bits ^= static_cast<unsigned char>(character);
        bits *= 0x100000001b3u;
    }
    return avalanche(bits);
}

std::uint64_t seed_of(std::string_view const experiment, std::string_view const state_point,
                      int const replicate) {
    return hash_of(fmt::format("{}|{}|{}", experiment, state_point, replicate)) >> 1;
}

} // namespace clack::validation
