// packet.h — per-thread memory of the packets. Private to the engine.
#pragma once

#include <cstddef>
#include <vector>

#include "tracer/engine/tile.h"

namespace whittle {

inline constexpr std::size_t kMostLanes = 16;

// A cache line of raw memory: what holds vectors, whose type depends on the instruction set.
struct alignas(64) RawLine {
    std::byte bytes[64];
};

// A set of the packets of a tile, by number.
struct PacketMask {
    std::array<std::uint64_t, kTileRays / 64> words{};
    bool has(std::size_t i) const { return ((words[i / 64] >> (i % 64)) & 1) != 0; }
    // Requires: `n` < 64 divides 64, `at` is a multiple of it.
    void put(std::size_t at, std::size_t n, std::uint64_t bits) { words[at / 64] |= (bits & ((std::uint64_t{1} << n) - 1)) << (at % 64); }
    std::size_t count() const {
        std::size_t n = 0;
        for (const std::uint64_t w : words) n += static_cast<std::size_t>(__builtin_popcountll(w));
        return n;
    }
    // Drops the numbers from `n` on.
    void keep(std::size_t n) {
        for (std::size_t w = 0; w < words.size(); ++w)
            if (n < 64 * (w + 1)) words[w] &= n <= 64 * w ? 0 : ~std::uint64_t{0} >> (64 * (w + 1) - n);
    }
    template <class Visit>
    void each(Visit visit) const {
        for (std::size_t w = 0; w < words.size(); ++w)
            for (std::uint64_t left = words[w]; left != 0; left &= left - 1) visit(64 * w + static_cast<std::size_t>(__builtin_ctzll(left)));
    }
};

struct TileMemory {
    using Row = std::array<double, kTileRays>;
    alignas(64) std::array<Row, 3> o, d;
    alignas(64) Row t, error;                            // the nearest event so far; t is +inf where there is none. Its bound, in the end
    alignas(64) std::array<std::uint64_t, kTileRays> id;
    alignas(64) Row use;                                 // that its border shows; +inf where unknown yet
    alignas(64) std::array<Row, 3> normal;
    bool any = false;                                     // any hit before t is wanted, which becomes -inf where there is one
    alignas(64) std::array<std::uint64_t, kTileRays> departed;  // for any hits: the event left (class << 1 | crossing), or ~0
    std::array<bool, kTileRays> deferred;
    TileTree tree, labels;
    bool labels_built = false;  // `labels` is of the octree's cell last met
    std::vector<RawLine> cuts, label_cuts, packets, bounds;
    std::vector<PacketMask> masks;  // by slot of the tree
    std::vector<std::uint8_t> filled, label_filled;
};

}  // namespace whittle
