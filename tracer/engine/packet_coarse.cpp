// packet_coarse.cpp — the packets once more, in float: which crossing each ray of a tile meets first, where float can tell.
//
// Twice as many lanes in a vector, and roots and quotients in a third of the time; the bounds are those of the packets in double with another unit
// (docs/numerics.md, bounds of a tile), so a lane that is decided here is decided the same way there. Its t, bound and normal are taken in double afterwards.
#include "tracer/engine/packet_coarse.h"

#include <algorithm>
#include <cstring>

#include "tracer/engine/certificates.h"

#define WHITTLE_COARSE 1
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/engine/packet_coarse_targets.inc"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>  // NOLINT: includes packet_coarse_targets.inc for every target but the last
#include <hwy/highway.h>

#include "tracer/engine/packet_coarse_targets.inc"

namespace whittle {

HWY_EXPORT(coarse_hits);

namespace {

// Float has to tell all but this share of a tile's rays, as a ray alone takes as long as ten or twenty together; else the tile is met in double, and so are the
// next ones, up to kMostPause of them.
constexpr std::size_t kLeastShare = 20;
constexpr std::uint32_t kMostPause = 31;
constexpr double kBehind = 1 + 0x1p-6;

std::array<double, 3> corner(const Vec3& p) { return {p.x, p.y, p.z}; }

// Is the tile one for packets in float? They want one origin, and numbers whose products are numbers.
bool fits_float(const Program& program, const TileExtremes& e, const TileScope& scope) {
    if (!program.makes(EnginePass::kCoarse) || !kCertifies || !program.space.empty() || program.leaves.size() >= (1u << 22) || program.classes.size() >= (1u << 30))
        return false;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (e.o_lo[i] != e.o_hi[i]) return false;
        const double d = std::max(std::abs(e.d_lo[i]), std::abs(e.d_hi[i]));
        most += d * d;
    }
    const double reach = 0.5 * scope.horizon * std::sqrt(e.least_square);
    return e.least_square >= kLeastCoarseSquare && most <= kMostCoarseSquare && reach >= kLeastCoarseReach && reach <= kMostCoarseReach;
}

// The nearest or any crossings of the rays last loaded into `m.coarse`. How many are open; more than there are where float is not asked, or of no use.
std::size_t find_in_float(const Program& program, const TileBounds& bounds, std::size_t count, TileMemory& m) {
    const std::size_t none = count + 1;
    const TileScope scope = m.tree.scope();
    if (!fits_float(program, bounds.extremes, scope)) return none;
    if (m.coarse_pause > 0) {
        --m.coarse_pause;
        return none;
    }
    TileScope coarse = scope;
    coarse.coarse = true;
    // What is behind the solid as the tile sees it does not matter; a share more than that is as good as behind it for every bound.
    double near = 0, far = HUGE_VAL;
    if (bounds.meets(corner(program.bounds.lo), corner(program.bounds.hi), near, far)) coarse.horizon = std::min(scope.horizon, kBehind * far);
    m.tree.begin(program, coarse);
    const std::size_t open = HWY_DYNAMIC_DISPATCH(coarse_hits)(program, bounds, count, m);
    if (open * kLeastShare <= count) {
        m.coarse_failures = 0;
        return open;
    }
    m.coarse_failures = std::min(2 * m.coarse_failures + 1, kMostPause);
    m.coarse_pause = m.coarse_failures;
    m.tree.begin(program, scope);
    return none;
}

}  // namespace

bool hits_in_float(const Program& program, const TileBounds& bounds, std::size_t count, TileMemory& m, EngineCounters& counters) {
    const std::size_t open = find_in_float(program, bounds, count, m);
    if (open > count) return false;
    finish_hits_in_float(program, count, m);
    counters.skipped_by(EnginePass::kCoarse) += count - open;
    return true;
}

bool blocked_in_float(const Program& program, const TileBounds& bounds, std::size_t count, TileMemory& m, EngineCounters& counters) {
    if (std::any_of(m.departed.begin(), m.departed.begin() + static_cast<std::ptrdiff_t>(count), [](std::uint64_t id) { return id != ~std::uint64_t{0}; })) return false;
    const std::size_t open = find_in_float(program, bounds, count, m);
    if (open > count) return false;
    for (std::size_t k = 0; k < count; ++k) m.t[k] = m.coarse.t[k];
    counters.skipped_by(EnginePass::kCoarse) += count - open;
    return true;
}

}  // namespace whittle
