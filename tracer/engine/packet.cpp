// packet.cpp — first hits of a tile of rays, many lanes at a time.
//
// The tile's bounds fold the program to a small tree (tile.h); packets of as many rays as the processor has lanes walk it (packet_walk.inc); a union at
// the root is not folded whole but met front to back, each part once for all packets it may still concern. What double cannot decide, rays that start
// inside or on surfaces, and leaves no packet knows are asked again of the single-ray engine: so every hit is first_hit()'s, to the bit.
// Source: the tile and its folded tree: Duff, Interval arithmetic and recursive subdivision for implicit functions and CSG (1992).
#include "tracer/engine/packet.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "tracer/engine/gradient.h"
#include "tracer/engine/packet_coarse.h"
#include "tracer/engine/rows.h"
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
HWY_EXPORT(take_rows);
HWY_EXPORT(finish_coarse_hits);

namespace {

// Above this, rays that do not go together are met one by one: eight of them touch too many parts. Incoherent rays in packets against one by one, first hit and
// any hit: 5 leaves 3.6 and 4.1 times as fast; 13 to 27 of parts to be printed 1.7 to 3.8 and 1.2 to 2.4; 28 bars 0.82 and 0.61; 34 to 53 leaves 0.65 to 1.04 and
// 0.55 to 0.81.
constexpr std::size_t kMostLeavesApart = 30;

std::size_t padded_to_lanes(std::size_t count) { return (count + kMostLanes - 1) / kMostLanes * kMostLanes; }

// The last ray stands for those that fill the packets up.
void fill_up(TileMemory& m, std::size_t count) {
    for (std::size_t k = count; k < padded_to_lanes(count); ++k)
        for (std::size_t i = 0; i < 3; ++i) m.own_o[i][k] = m.own_o[i][count - 1], m.own_d[i][k] = m.own_d[i][count - 1];
}

// Of the rays last loaded. False: some coordinate is no number, or not finite.
bool measure(const TileMemory& m, std::size_t count, TileExtremes& extremes) {
    return HWY_DYNAMIC_DISPATCH(tile_extremes)(m, padded_to_lanes(count), extremes) && extremes.least_square > 0;
}

void load_rays(const Ray* rays, std::size_t count, TileMemory& m) {
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < 3; ++i) {
            m.own_o[i][k] = rays[k].origin[static_cast<int>(i)];
            m.own_d[i][k] = rays[k].direction[static_cast<int>(i)];
        }
    fill_up(m, count);
    m.use_own_rays();
}

// Whole vectors need no copy.
bool stand_in_place(std::size_t count) { return count % kMostLanes == 0; }

void load_rows(const RayRows& rays, int first, std::size_t count, TileMemory& m) {
    if (stand_in_place(count)) {
        for (std::size_t i = 0; i < 3; ++i) m.o[i] = rays.origin[i] + first, m.d[i] = rays.direction[i] + first;
        return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        std::copy_n(rays.origin[i] + first, count, m.own_o[i].begin());
        std::copy_n(rays.direction[i] + first, count, m.own_d[i].begin());
    }
    fill_up(m, count);
    m.use_own_rays();
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

// At most kTileRays rays, which are handed as one tile to `answer`(bounds, shared, first, count) if they go together; else a few at a time, or, where that
// does not pay or some coordinate is not finite, to `alone`(first, count).
template <class Io, class Answer, class Alone>
void meet_tile(const Program& program, const Io& io, int first, int count, TileMemory& m, Answer answer, Alone alone) {
    TileExtremes extremes;
    io.load(first, static_cast<std::size_t>(count), m);
    if (!measure(m, static_cast<std::size_t>(count), extremes)) return alone(first, count);
    const TileBounds bounds = tile_bounds(extremes);
    const TileScope scope = tile_scope(extremes, program.bounds);
    if (!(scope.horizon < HUGE_VAL)) return alone(first, count);
    m.tree.begin(program, scope);
    if (bounds.coherent) return answer(bounds, false, first, count);
    constexpr int kFew = static_cast<int>(kMostLanes);
    for (int i = first; i < first + count; i += kFew) {
        const int few = std::min(kFew, first + count - i);
        io.load(i, static_cast<std::size_t>(few), m);
        measure(m, static_cast<std::size_t>(few), extremes);
        const TileBounds near = tile_bounds(extremes);
        if (near.coherent || program.leaves.size() <= kMostLeavesApart) {
            answer(near, true, i, few);
        } else {
            alone(i, few);
        }
    }
}

// Rays and their hits, one by one.
struct OneByOne {
    const Ray* rays;
    Hit* hits;
    bool* found;

    void load(int first, std::size_t count, TileMemory& m) const {
        load_rays(rays + first, count, m);
        m.use_own_ends();
    }
    void ask_alone(const Program& program, int i, double t_max, Scratch& scratch) const { found[i] = first_hit(program, rays[i], t_max, scratch, hits[i]); }
    // Of the tile's rays, which stand from `first` on.
    void take(const Program& program, const TileMemory& m, int first, int count, double t_max, Scratch& scratch) const {
        for (int i = first; i < first + count; ++i) {
            const auto k = static_cast<std::size_t>(i - first);
            if (m.deferred[k] || rays[i].departure != nullptr) {
                ++scratch.counters.packet_deferred;
                ask_alone(program, i, t_max, scratch);
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
};

// The first deferred ray of a tile's from `k` on; `count` where there is none.
std::size_t next_deferred(const TileMemory& m, std::size_t k, std::size_t count) {
    const void* found = std::memchr(m.deferred.data() + k, 1, count - k);
    return found == nullptr ? count : static_cast<std::size_t>(static_cast<const bool*>(found) - m.deferred.data());
}

// Rays and their hits in rows.
struct InRows {
    const RayRows& rays;
    const HitRows& hits;

    void load(int first, std::size_t count, TileMemory& m) const {
        load_rows(rays, first, count, m);
        m.use_own_ends();
        if (!stand_in_place(count)) return;
        m.error = hits.t_error + first;
        for (std::size_t axis = 0; axis < 3; ++axis) m.normal[axis] = hits.normal[axis] + first;
    }
    void ask_alone(const Program& program, int i, double t_max, Scratch& scratch) const {
        Hit hit;
        const bool found = first_hit(program, rays.ray(i), t_max, scratch, hit);
        hits.t[i] = found ? hit.end.t : HUGE_VAL;
        hits.t_error[i] = hit.end.t_error;
        for (std::size_t axis = 0; axis < 3; ++axis) hits.normal[axis][i] = hit.end.normal[static_cast<int>(axis)];
        hits.surface[i] = hit.end.surface;
        hits.use[i] = hit.end.use;
    }
    void take(const Program& program, const TileMemory& m, int first, int count, double t_max, Scratch& scratch) const {
        const auto n = static_cast<std::size_t>(count);
        HWY_DYNAMIC_DISPATCH(take_rows)(m, n, t_max, hits.t + first, hits.surface + first, hits.use + first);
        if (!stand_in_place(n)) {
            std::copy_n(m.error, n, hits.t_error + first);
            for (std::size_t axis = 0; axis < 3; ++axis) std::copy_n(m.normal[axis], n, hits.normal[axis] + first);
        }
        std::uint64_t alone = 0;
        for (std::size_t k = next_deferred(m, 0, n); k < n; k = next_deferred(m, k + 1, n)) {
            ++alone;
            ask_alone(program, first + static_cast<int>(k), t_max, scratch);
        }
        for (std::size_t k = 0; program.some_uncertified && k < n; ++k)
            if (!m.deferred[k] && m.t[k] <= t_max && m.t[k] < HUGE_VAL) scratch.counters.uncertified += !program.class_labels[m.id[k] >> 1].exact;
        scratch.counters.packet_deferred += alone;
        scratch.counters.packet_rays += n - alone;
        scratch.counters.skipped_by(EnginePass::kFirst) += n - alone;
    }
};

template <class Io>
void hits_alone(const Program& program, const Io& io, int first, int count, double t_max, Scratch& scratch) {
    for (int i = first; i < first + count; ++i) io.ask_alone(program, i, t_max, scratch);
}

// Of the rays last loaded: at most kTileRays that go together, or kMostLanes that need not.
template <class Io>
void hits_of_packets(const Program& program, const TileBounds& bounds, bool shared, const Io& io, int first, int count, double t_max, Scratch& scratch) {
    TileMemory& m = scratch.impl->tile;
    const auto n = static_cast<std::size_t>(count);
    if (shared || !hits_in_float(program, bounds, n, m, scratch.counters))
        HWY_DYNAMIC_DISPATCH(tile_hits)(program, bounds, n, m, bounds.coherent, shared);
    take_work(m, scratch.counters);
    io.take(program, m, first, count, t_max, scratch);
}

template <class Io>
void hits_of_tile(const Program& program, const Io& io, int first, int count, double t_max, Scratch& scratch) {
    TileMemory& m = scratch.impl->tile;
    const auto answer = [&](const TileBounds& bounds, bool shared, int from, int n) { hits_of_packets(program, bounds, shared, io, from, n, t_max, scratch); };
    const auto alone = [&](int from, int n) { hits_alone(program, io, from, n, t_max, scratch); };
    meet_tile(program, io, first, count, m, answer, alone);
}

template <class Io>
void hits_of_all(const Program& program, const Io& io, int count, double t_max, Scratch& scratch) {
    // Packets are made of these passes.
    if (!program.makes(EnginePass::kFirst) || !program.makes(EnginePass::kFilter) || program.mostly_turned) return hits_alone(program, io, 0, count, t_max, scratch);
    for (int i = 0; i < count; i += kTileRays) hits_of_tile(program, io, i, std::min(count - i, kTileRays), t_max, scratch);
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

// Rays one by one, or in rows, and whether each is blocked before its own t_max.
struct AnyOneByOne {
    const Ray* rays;
    const double* t_max;
    bool* blocked;

    Ray ray(int i) const { return rays[i]; }
    void load(int first, std::size_t count, TileMemory& m) const { load_rays(rays + first, count, m); }
    bool departs(const Program& program, int i, std::uint64_t& id) const { return departure_of(program, rays[i], id); }
};

struct AnyInRows {
    const RayRows& rays;
    const double* t_max;
    bool* blocked;

    Ray ray(int i) const { return rays.ray(i); }
    void load(int first, std::size_t count, TileMemory& m) const { load_rows(rays, first, count, m); }
    bool departs(const Program&, int, std::uint64_t& id) const {
        id = ~std::uint64_t{0};
        return true;
    }
};

template <class Io>
void any_alone(const Program& program, const Io& io, int first, int count, Scratch& scratch) {
    for (int i = first; i < first + count; ++i) io.blocked[i] = any_hit(program, io.ray(i), io.t_max[i], scratch);
}

// Of the rays last loaded.
template <class Io>
void any_of_packets(const Program& program, const TileBounds& bounds, bool shared, const Io& io, int first, int count, Scratch& scratch) {
    TileMemory& m = scratch.impl->tile;
    std::array<bool, kTileRays> alone;
    const auto n = static_cast<std::size_t>(count), padded = padded_to_lanes(n);
    for (std::size_t k = 0; k < padded; ++k) {
        const int i = first + static_cast<int>(std::min(k, n - 1));
        alone[k] = !io.departs(program, i, m.departed[k]);
        // A lane that is asked alone anyway looks for nothing.
        m.t[k] = alone[k] ? -HUGE_VAL : io.t_max[i];
    }
    m.any = true;
    if (shared || !blocked_in_float(program, bounds, n, m, scratch.counters)) HWY_DYNAMIC_DISPATCH(tile_hits)(program, bounds, n, m, bounds.coherent, shared);
    m.any = false;
    take_work(m, scratch.counters);
    for (std::size_t k = 0; k < n; ++k) {
        const int i = first + static_cast<int>(k);
        io.blocked[i] = m.t[k] == -HUGE_VAL;
        // Blocked is blocked, whatever else was close.
        if (alone[k] || (m.deferred[k] && !io.blocked[i])) {
            ++scratch.counters.packet_deferred;
            any_alone(program, io, i, 1, scratch);
        } else {
            ++scratch.counters.packet_rays;
            ++scratch.counters.skipped_by(EnginePass::kAny);
        }
    }
}

template <class Io>
void any_of_tile(const Program& program, const Io& io, int first, int count, Scratch& scratch) {
    TileMemory& m = scratch.impl->tile;
    const auto answer = [&](const TileBounds& bounds, bool shared, int from, int n) { any_of_packets(program, bounds, shared, io, from, n, scratch); };
    const auto alone = [&](int from, int n) { any_alone(program, io, from, n, scratch); };
    meet_tile(program, io, first, count, m, answer, alone);
}

template <class Io>
void any_of_all(const Program& program, const Io& io, int count, Scratch& scratch) {
    if (!program.makes(EnginePass::kFilter) || program.mostly_turned) return any_alone(program, io, 0, count, scratch);
    for (int i = 0; i < count; i += kTileRays) any_of_tile(program, io, i, std::min(count - i, kTileRays), scratch);
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

void finish_hits_in_float(const Program& program, std::size_t rays, TileMemory& memory) { HWY_DYNAMIC_DISPATCH(finish_coarse_hits)(program, rays, memory); }

void any_hits(const Program& program, const Ray* rays, const double* t_max, int count, Scratch& scratch, bool* blocked) {
    if (program.empty || program.everything) {
        std::fill(blocked, blocked + count, program.everything);
        return;
    }
    if (!program.makes(EnginePass::kAny)) return any_of_first(program, rays, t_max, count, scratch, blocked);
    any_of_all(program, AnyOneByOne{rays, t_max, blocked}, count, scratch);
}

void any_hits(const Program& program, const RayRows& rays, const double* t_max, int count, Scratch& scratch, bool* blocked) {
    if (program.empty || program.everything) {
        std::fill(blocked, blocked + count, program.everything);
        return;
    }
    if (program.makes(EnginePass::kAny)) return any_of_all(program, AnyInRows{rays, t_max, blocked}, count, scratch);
    for (int i = 0; i < count; ++i) {
        const Ray ray = rays.ray(i);
        any_of_first(program, &ray, t_max + i, 1, scratch, blocked + i);
    }
}

void first_hits(const Program& program, const Ray* rays, int count, double t_max, Scratch& scratch, Hit* hits, bool* found) {
    if (program.empty || program.everything) {
        std::fill(found, found + count, false);
        return;
    }
    hits_of_all(program, OneByOne{rays, hits, found}, count, t_max, scratch);
}

void first_hits(const Program& program, const RayRows& rays, int count, double t_max, Scratch& scratch, const HitRows& hits) {
    if (program.empty || program.everything) {
        std::fill_n(hits.t, count, HUGE_VAL);
        return;
    }
    hits_of_all(program, InRows{rays, hits}, count, t_max, scratch);
}

}  // namespace whittle
