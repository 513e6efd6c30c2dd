// packet.h — per-thread memory of the packets. Private to the engine.
#pragma once

#include <cstddef>
#include <vector>

#include "tracer/engine/tile.h"

namespace whittle {

inline constexpr std::size_t kMostLanes = 8;

// A cache line of raw memory: what holds vectors, whose type depends on the instruction set.
struct alignas(64) RawLine {
    std::byte bytes[64];
};

struct TileMemory {
    using Row = std::array<double, kTileRays>;
    alignas(64) std::array<Row, 3> o, d;
    alignas(64) Row t, error;                            // the nearest event so far; t is +inf where there is none
    alignas(64) std::array<std::uint64_t, kTileRays> id;
    alignas(64) Row use;                                 // that its border shows; +inf where unknown yet
    alignas(64) std::array<Row, 3> normal;
    std::array<bool, kTileRays> deferred;
    TileTree tree;
    std::vector<RawLine> cuts, packets;
    std::vector<std::uint8_t> filled;
};

}  // namespace whittle
