// packet.h — per-thread memory of the packets. Private to the engine.
#pragma once

#include <cstddef>
#include <vector>

#include "tracer/engine/tile.h"

namespace whittle {

inline constexpr std::size_t kMostLanes = 16;        // of doubles
inline constexpr std::size_t kMostCoarseLanes = 32;  // of floats

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

// A number a ray of a tile.
template <class T>
struct alignas(64) TileRow : std::array<T, kTileRays> {};

// The nearest events so far, by ray.
template <class Real, class Id>
struct NearRows {
    TileRow<Real> t;  // +inf where there is none
    TileRow<Id> id;
    TileRow<Real> use;  // that the border shows; +inf where unknown yet
};

// A box that a tile may meet, none of its rays before `near`.
struct WaitingBox {
    WideChild child;
    double near = 0;
};

struct TileMemory : NearRows<double, std::uint64_t> {
    // The rays, and what is told of their hits in the end besides t: rows of the caller's, or those below.
    std::array<const double*, 3> o, d;
    double* error;  // the bound of t
    std::array<double*, 3> normal;
    std::array<TileRow<double>, 3> own_o, own_d, own_normal;
    TileRow<double> own_error;

    void use_own_rays() {
        for (std::size_t i = 0; i < 3; ++i) o[i] = own_o[i].data(), d[i] = own_d[i].data();
    }
    void use_own_ends() {
        error = own_error.data();
        for (std::size_t i = 0; i < 3; ++i) normal[i] = own_normal[i].data();
    }
    NearRows<float, std::uint32_t> coarse;
    std::array<TileRow<float>, 3> coarse_d, coarse_off;  // directions, and how far they are off the middle of the tile's
    std::uint32_t coarse_failures = 0, coarse_pause = 0;  // tiles that float left open, in a row, and tiles yet to be met without it
    bool any = false;                                     // any hit before t is wanted, which becomes -inf where there is one
    TileRow<std::uint64_t> departed;  // for any hits: the event left (class << 1 | crossing), or ~0
    std::array<bool, kTileRays> deferred;
    TileTree tree, labels;
    bool labels_built = false;  // `labels` is of the octree's cell last met
    std::vector<RawLine> cuts, label_cuts, packets, bounds;
    std::vector<PacketMask> masks;  // by slot of the tree
    std::vector<WaitingBox> waiting;
    std::vector<std::uint8_t> filled, label_filled;
};

}  // namespace whittle
