// packet.cpp — first hits of a tile of rays, many lanes at a time.
//
// The tile's bounds fold the program to a small tree (tile.h); packets of as many rays as the processor has lanes walk it (packet_walk.inc); a union at
// the root is not folded whole but met front to back, each part once for all packets it may still concern. What double cannot decide, rays that start
// inside or on surfaces, and leaves no packet knows are asked again of the single-ray engine: so every hit is first_hit()'s, to the bit.
// Source: the tile and its folded tree: Duff, Interval arithmetic and recursive subdivision for implicit functions and CSG (1992).
#include "tracer/engine/packet.h"

#include <algorithm>

#include "tracer/engine/gradient.h"
#include "tracer/engine/scratch.h"

// The single-ray kernel stands above; from here on the text is compiled once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/engine/packet_targets.inc"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>  // NOLINT: includes packet_targets.inc for every target but the last
#include <hwy/highway.h>

#include "tracer/engine/packet_targets.inc"

namespace whittle {

HWY_EXPORT(tile_hits);

namespace {

// False: the rays do not go together.
bool load_tile(const Ray* rays, int count, TileMemory& m, TileBounds& bounds) {
    std::array<double, 3> o_lo, o_hi, d_lo, d_hi;
    for (std::size_t i = 0; i < 3; ++i) {
        o_lo[i] = d_lo[i] = HUGE_VAL;
        o_hi[i] = d_hi[i] = -HUGE_VAL;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
            const double o = rays[k].origin[static_cast<int>(i)], d = rays[k].direction[static_cast<int>(i)];
            m.o[i][k] = o;
            m.d[i][k] = d;
            o_lo[i] = std::min(o_lo[i], o);
            o_hi[i] = std::max(o_hi[i], o);
            d_lo[i] = std::min(d_lo[i], d);
            d_hi[i] = std::max(d_hi[i], d);
        }
        const std::size_t padded = (static_cast<std::size_t>(count) + kMostLanes - 1) / kMostLanes * kMostLanes;
        for (auto k = static_cast<std::size_t>(count); k < padded; ++k) {
            m.o[i][k] = m.o[i][k - 1];
            m.d[i][k] = m.d[i][k - 1];
        }
    }
    bounds = tile_bounds(o_lo, o_hi, d_lo, d_hi);
    return bounds.coherent;
}

void make_hit(const TileMemory& m, std::size_t k, const Ray& ray, Hit& hit) {
    const auto id = static_cast<ClassId>(m.id[k] >> 1);
    hit.end.t = std::max(m.t[k], 0.0);
    hit.end.t_error = m.error[k];
    hit.end.normal = {m.normal[0][k], m.normal[1][k], m.normal[2][k]};
    hit.end.surface = id;
    hit.end.use = static_cast<std::uint32_t>(m.use[k]);
    hit.end.certified = true;
    hit.point = point_at(ray, m.t[k]);
    hit.from_inside = false;
    hit.departure.classes[0] = id;
    hit.departure.count = 1;
}

void hits_of_tile(const Program& program, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits, bool* found) {
    TileMemory& m = scratch.impl->tile;
    TileBounds bounds;
    const bool together = count > 1 && load_tile(rays, count, m, bounds);
    if (together) {
        scratch.counters.primitive_tests += HWY_DYNAMIC_DISPATCH(tile_hits)(program, bounds, static_cast<std::size_t>(count), m);
        scratch.counters.spans_evaluated += static_cast<std::uint64_t>(count);
    }
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (!together || m.deferred[k] || rays[i].departure != nullptr) {
            found[i] = first_hit(program, rays[i], t_max, scratch, hits[i]);
            continue;
        }
        found[i] = m.t[k] < HUGE_VAL && m.t[k] <= t_max;
        if (found[i]) make_hit(m, k, rays[i], hits[i]);
    }
}

}  // namespace

void first_hits(const Program& program, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits, bool* found) {
    if (program.empty || program.everything) {
        std::fill(found, found + count, false);
        return;
    }
    for (int i = 0; i < count; i += kTileRays) hits_of_tile(program, rays + i, std::min(count - i, kTileRays), t_max, scratch, hits + i, found + i);
}

}  // namespace whittle
