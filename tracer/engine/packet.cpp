// packet.cpp — first hits of a tile of rays, many lanes at a time.
//
// The tile's bounds fold the program to a small tree (tile.h); packets of as many rays as the processor has lanes walk it (packet_walk.inc); a union at
// the root is not folded whole but met front to back, each part once for all packets it may still concern. What double cannot decide, rays that start
// inside or on surfaces, and leaves no packet knows are asked again of the single-ray engine: so every hit is first_hit()'s, to the bit.
// Source: the tile and its folded tree: Duff, Interval arithmetic and recursive subdivision for implicit functions and CSG (1992).
#include "tracer/engine/packet.h"

#include <algorithm>
#include <utility>

#include "tracer/engine/gradient.h"
#include "tracer/engine/scratch.h"
#include "tracer/engine/space.h"

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
// 5 leaves 5.1 times as fast, 201 0.68, 512 1.15, 1201 1.14; any hit 4.8, 0.99, 0.79, 1.07.
constexpr std::size_t kMostLeavesApart = 100;

// False: some coordinate is no number, or not finite.
bool load_tile(const Ray* rays, std::size_t count, TileMemory& m, TileExtremes& extremes) {
    const std::size_t padded = (count + kMostLanes - 1) / kMostLanes * kMostLanes;
    for (std::size_t k = 0; k < padded; ++k) {
        const Ray& ray = rays[std::min(k, count - 1)];
        for (std::size_t i = 0; i < 3; ++i) {
            m.o[i][k] = ray.origin[static_cast<int>(i)];
            m.d[i][k] = ray.direction[static_cast<int>(i)];
        }
    }
    return HWY_DYNAMIC_DISPATCH(tile_extremes)(m, padded, extremes) && extremes.least_square > 0;
}

void take_work(TileMemory& m, EngineCounters& counters) {
    for (TileTree* tree : {&m.tree, &m.labels}) {
        const TileWork work = std::exchange(tree->work, {});
        counters.primitive_tests += work.tests;
        counters.folded += work.folded;
        counters.skipped_by(EnginePass::kFrustum) += work.pruned;
        counters.skipped_by(EnginePass::kWindows) += work.beyond;
        counters.skipped_by(EnginePass::kOcclusion) += work.hidden;
        counters.skipped_by(EnginePass::kMasks) += work.masked;
        counters.skipped_by(EnginePass::kCells) += work.constant;
    }
}

void make_hit(const Program& program, const TileMemory& m, std::size_t k, const Ray& ray, Hit& hit) {
    const auto id = static_cast<ClassId>(m.id[k] >> 1);
    hit.end.t = std::max(m.t[k], 0.0);
    hit.end.t_error = m.error[k];
    hit.end.normal = {m.normal[0][k], m.normal[1][k], m.normal[2][k]};
    hit.end.surface = id;
    hit.end.use = static_cast<std::uint32_t>(m.use[k]);
    hit.end.certified = program.class_labels[id].exact;
    hit.point = point_at(ray, m.t[k]);
    hit.from_inside = false;
    hit.departure.classes[0] = id;
    hit.departure.count = 1;
}

void hits_alone(const Program& program, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits, bool* found) {
    for (int k = 0; k < count; ++k) found[k] = first_hit(program, rays[k], t_max, scratch, hits[k]);
}

// Of the rays last loaded: at most kTileRays that go together, or kMostLanes that need not.
void hits_of_packets(const Program& program, const TileBounds& bounds, bool shared, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits,
                     bool* found) {
    TileMemory& m = scratch.impl->tile;
    HWY_DYNAMIC_DISPATCH(tile_hits)(program, bounds, static_cast<std::size_t>(count), m, bounds.coherent, shared);
    take_work(m, scratch.counters);
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (m.deferred[k] || rays[i].departure != nullptr) {
            ++scratch.counters.packet_deferred;
            found[i] = first_hit(program, rays[i], t_max, scratch, hits[i]);
            continue;
        }
        ++scratch.counters.packet_rays;
        ++scratch.counters.skipped_by(EnginePass::kFirst);
        found[i] = m.t[k] < HUGE_VAL && m.t[k] <= t_max;
        if (!found[i]) continue;
        make_hit(program, m, k, rays[i], hits[i]);
        scratch.counters.uncertified += !hits[i].end.certified;
    }
}

void hits_of_tile(const Program& program, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits, bool* found) {
    TileMemory& m = scratch.impl->tile;
    TileExtremes extremes;
    if (!load_tile(rays, static_cast<std::size_t>(count), m, extremes)) return hits_alone(program, rays, count, t_max, scratch, hits, found);
    const TileBounds bounds = tile_bounds(extremes);
    const TileScope scope = tile_scope(extremes, program.bounds);
    if (!(scope.horizon < HUGE_VAL)) return hits_alone(program, rays, count, t_max, scratch, hits, found);
    m.tree.begin(program, scope);
    if (bounds.coherent) return hits_of_packets(program, bounds, false, rays, count, t_max, scratch, hits, found);
    constexpr int kFew = static_cast<int>(kMostLanes);
    for (int i = 0; i < count; i += kFew) {
        const int few = std::min(kFew, count - i);
        load_tile(rays + i, static_cast<std::size_t>(few), m, extremes);
        const TileBounds near = tile_bounds(extremes);
        if (near.coherent || program.leaves.size() <= kMostLeavesApart) {
            hits_of_packets(program, near, true, rays + i, few, t_max, scratch, hits + i, found + i);
        } else {
            hits_alone(program, rays + i, few, t_max, scratch, hits + i, found + i);
        }
    }
}

// The event that a ray leaves, as its packet knows it. False: packets do not know such departures.
bool departure_of(const Program& program, const Ray& ray, std::uint64_t& id) {
    constexpr double kLeastCosine = 0x1p-7;  // nearer to grazing, which of two crossings is left is not plain
    id = ~std::uint64_t{0};
    if (ray.departure == nullptr || ray.departure->count == 0) return true;
    if (ray.departure->count > 1) return false;
    const ClassId c = ray.departure->classes[0];
    const Support& s = program.classes[c];
    id = std::uint64_t{c} << 1;
    if (is_plane(s.kind)) return true;
    const Frame& frame = program.frames[s.frame];
    if (degree_of(s.kind) != 2 || frame.motion != 0) return false;
    const double along = glm::dot(unit_gradient(s, frame, ray.origin), ray.direction);
    bool second = along > 0;
    if (s.kind == SupportKind::kCone || s.kind == SupportKind::kQuadric) {
        // Steeper than the cone the ray goes out by its first crossing and in by its second.
        const auto form = single::quadratic_form<double>(s, ray_in_frame(frame, ray));
        if (!(std::abs(form.a) > form.ea)) return false;
        second = second == (form.a > 0);
    }
    if (second) id |= 1;
    return std::abs(along) > kLeastCosine * glm::length(ray.direction);
}

void any_alone(const Program& program, const Ray* rays, const double* t_max, int count, Scratch& scratch, bool* blocked) {
    for (int k = 0; k < count; ++k) blocked[k] = any_hit(program, rays[k], t_max[k], scratch);
}

// Of the rays last loaded.
void any_of_packets(const Program& program, const TileBounds& bounds, bool shared, const Ray* rays, const double* t_max, int count, Scratch& scratch,
                    bool* blocked) {
    TileMemory& m = scratch.impl->tile;
    std::array<bool, kTileRays> alone;
    const auto n = static_cast<std::size_t>(count), padded = (n + kMostLanes - 1) / kMostLanes * kMostLanes;
    for (std::size_t k = 0; k < padded; ++k) {
        const std::size_t ray = std::min(k, n - 1);
        alone[k] = !departure_of(program, rays[ray], m.departed[k]);
        // A lane that is asked alone anyway looks for nothing.
        m.t[k] = alone[k] ? -HUGE_VAL : t_max[ray];
    }
    m.any = true;
    HWY_DYNAMIC_DISPATCH(tile_hits)(program, bounds, n, m, bounds.coherent, shared);
    m.any = false;
    take_work(m, scratch.counters);
    for (std::size_t k = 0; k < n; ++k) {
        blocked[k] = m.t[k] == -HUGE_VAL;
        // Blocked is blocked, whatever else was close.
        if (alone[k] || (m.deferred[k] && !blocked[k])) {
            ++scratch.counters.packet_deferred;
            blocked[k] = any_hit(program, rays[k], t_max[k], scratch);
        } else {
            ++scratch.counters.packet_rays;
            ++scratch.counters.skipped_by(EnginePass::kAny);
        }
    }
}

void any_of_tile(const Program& program, const Ray* rays, const double* t_max, int count, Scratch& scratch, bool* blocked) {
    TileMemory& m = scratch.impl->tile;
    TileExtremes extremes;
    if (!load_tile(rays, static_cast<std::size_t>(count), m, extremes)) return any_alone(program, rays, t_max, count, scratch, blocked);
    const TileBounds bounds = tile_bounds(extremes);
    const TileScope scope = tile_scope(extremes, program.bounds);
    if (!(scope.horizon < HUGE_VAL)) return any_alone(program, rays, t_max, count, scratch, blocked);
    m.tree.begin(program, scope);
    if (bounds.coherent) return any_of_packets(program, bounds, false, rays, t_max, count, scratch, blocked);
    constexpr int kFew = static_cast<int>(kMostLanes);
    for (int i = 0; i < count; i += kFew) {
        const int few = std::min(kFew, count - i);
        load_tile(rays + i, static_cast<std::size_t>(few), m, extremes);
        const TileBounds near = tile_bounds(extremes);
        if (near.coherent || program.leaves.size() <= kMostLeavesApart) {
            any_of_packets(program, near, true, rays + i, t_max + i, few, scratch, blocked + i);
        } else {
            any_alone(program, rays + i, t_max + i, few, scratch, blocked + i);
        }
    }
}

// With borders and normals that nobody asked for.
void any_of_first(const Program& program, const Ray* rays, const double* t_max, int count, Scratch& scratch, bool* blocked) {
    std::vector<Hit> hits(static_cast<std::size_t>(count));
    first_hits(program, rays, count, HUGE_VAL, scratch, hits.data(), blocked);
    for (int i = 0; i < count; ++i) {
        const Hit& hit = hits[static_cast<std::size_t>(i)];
        blocked[i] = hit.from_inside || (blocked[i] && hit.end.t < t_max[i]);
    }
}

}  // namespace

void any_hits(const Program& program, const Ray* rays, const double* t_max, int count, Scratch& scratch, bool* blocked) {
    if (program.empty || program.everything) {
        std::fill(blocked, blocked + count, program.everything);
        return;
    }
    if (!program.makes(EnginePass::kAny)) return any_of_first(program, rays, t_max, count, scratch, blocked);
    if (!program.makes(EnginePass::kFilter)) return any_alone(program, rays, t_max, count, scratch, blocked);
    for (int i = 0; i < count; i += kTileRays) any_of_tile(program, rays + i, t_max + i, std::min(count - i, kTileRays), scratch, blocked + i);
}

void first_hits(const Program& program, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits, bool* found) {
    if (program.empty || program.everything) {
        std::fill(found, found + count, false);
        return;
    }
    // Packets are made of these passes.
    if (!program.makes(EnginePass::kFirst) || !program.makes(EnginePass::kFilter)) return hits_alone(program, rays, count, t_max, scratch, hits, found);
    for (int i = 0; i < count; i += kTileRays) hits_of_tile(program, rays + i, std::min(count - i, kTileRays), t_max, scratch, hits + i, found + i);
}

}  // namespace whittle
