// seed.h — a fresh seed for each run of a random test, said aloud so that the run can be repeated.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <random>

namespace whittle::support {

// WHITTLE_SEED if set, else from the system's entropy.
inline std::uint64_t fresh_seed() {
    if (const char* said = std::getenv("WHITTLE_SEED")) return std::strtoull(said, nullptr, 10);
    std::random_device entropy;
    return (static_cast<std::uint64_t>(entropy()) << 32) | entropy();
}

// Where a long run of numbered trees begins: WHITTLE_FROM if set, else the first.
inline std::uint64_t first_of_run() {
    const char* said = std::getenv("WHITTLE_FROM");
    return said ? std::strtoull(said, nullptr, 10) : 0;
}

}  // namespace whittle::support
