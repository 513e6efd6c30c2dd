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

HWY_EXPORT(tile_extremes);
HWY_EXPORT(tile_hits);

namespace {

// Above this, rays that do not go together are met one by one: eight of them touch too many parts. Incoherent rays in packets against one by one:
// 5 leaves 4.4 times as fast, 201 1.4, 512 1.6, 1201 1.4; 1756 (Menger sponge) 0.6, 100,000 0.4.
constexpr std::size_t kMostLeavesApart = 1500;

// False: the rays do not go together.
bool load_tile(const Ray* rays, std::size_t count, TileMemory& m, TileBounds& bounds) {
    const std::size_t padded = (count + kMostLanes - 1) / kMostLanes * kMostLanes;
    bool numbers = true;  // a minimum passes over what is no number
    for (std::size_t k = 0; k < padded; ++k) {
        const Ray& ray = rays[std::min(k, count - 1)];
        for (std::size_t i = 0; i < 3; ++i) {
            m.o[i][k] = ray.origin[static_cast<int>(i)];
            m.d[i][k] = ray.direction[static_cast<int>(i)];
        }
        const double sum = ray.origin.x + ray.origin.y + ray.origin.z + ray.direction.x + ray.direction.y + ray.direction.z;
        numbers = numbers && sum == sum;
    }
    if (!numbers) return false;
    TileExtremes extremes;
    HWY_DYNAMIC_DISPATCH(tile_extremes)(m, padded, extremes);
    bounds = tile_bounds(extremes);
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

// Of at most kTileRays rays that go together, or kMostLanes that need not.
void hits_of_packets(const Program& program, const TileBounds& bounds, bool together, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits,
                     bool* found) {
    TileMemory& m = scratch.impl->tile;
    scratch.counters.primitive_tests += HWY_DYNAMIC_DISPATCH(tile_hits)(program, bounds, static_cast<std::size_t>(count), m, together);
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (m.deferred[k] || rays[i].departure != nullptr) {
            ++scratch.counters.packet_deferred;
            found[i] = first_hit(program, rays[i], t_max, scratch, hits[i]);
            continue;
        }
        ++scratch.counters.packet_rays;
        found[i] = m.t[k] < HUGE_VAL && m.t[k] <= t_max;
        if (found[i]) make_hit(m, k, rays[i], hits[i]);
    }
}

void hits_of_tile(const Program& program, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits, bool* found) {
    TileMemory& m = scratch.impl->tile;
    TileBounds bounds;
    if (load_tile(rays, static_cast<std::size_t>(count), m, bounds)) return hits_of_packets(program, bounds, true, rays, count, t_max, scratch, hits, found);
    constexpr int kFew = static_cast<int>(kMostLanes);
    for (int i = 0; i < count; i += kFew) {
        const int few = std::min(kFew, count - i);
        const bool together = load_tile(rays + i, static_cast<std::size_t>(few), m, bounds);
        if (together || program.leaves.size() <= kMostLeavesApart) {
            hits_of_packets(program, bounds, together, rays + i, few, t_max, scratch, hits + i, found + i);
        } else {
            for (int k = i; k < i + few; ++k) found[k] = first_hit(program, rays[k], t_max, scratch, hits[k]);
        }
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
