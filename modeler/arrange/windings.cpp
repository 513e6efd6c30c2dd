// windings.cpp — which operands lie in front of a face: a line along an axis through a point of the face, decided exactly.
#include <map>
#include <cmath>

#include "modeler/arrange/cells.h"

namespace whittle {
namespace {

// Points that lines are drawn through lie on a grid finer by 2^kFiner.
constexpr int kFiner = 20;

struct Probe {
    ExactPoint point;          // the coordinate along the axis means nothing
    std::array<Int128, 3> x{};  // times 2^kFiner
    int axis = 2;
};

// A point of the face by shares of its corners, seen along the axis; nothing where rounding takes it out of the face.
std::optional<Probe> probe_of(const Patches& patches, const SmallFace& face, int axis, const std::array<double, 3>& shares) {
    Probe p;
    p.axis = axis;
    for (std::size_t k = 0; k < 3; ++k) {
        double x = 0;
        for (std::size_t c = 0; c < 3; ++c) x += shares[c] * patches.points.near(face.v[c])[k];
        p.x[k] = static_cast<Int128>(std::floor(std::ldexp(x, kFiner)));
        p.point.x[k] = Wide<2>(p.x[k]).as<6>();
    }
    p.point.w = Wide<5>(std::int64_t{1} << kFiner);
    int first = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const int s = turn_of(patches.points.exact(face.v[c]), patches.points.exact(face.v[c == 2 ? 0 : c + 1]), p.point, axis);
        if (s == 0 || (first != 0 && s != first)) return std::nullopt;
        first = s;
    }
    return p;
}

// Of the plane's coordinate along the probe's axis, numerator over plane.n[axis] * 2^kFiner.
Wide<4> height(const ExactPlane& plane, const Probe& p) {
    const auto i = static_cast<std::size_t>((p.axis + 1) % 3), j = static_cast<std::size_t>((p.axis + 2) % 3);
    return (plane.offset() << kFiner).as<4>() - Wide<2>(plane.n[i]) * Wide<2>(p.x[i]) - Wide<2>(plane.n[j]) * Wide<2>(p.x[j]);
}

enum class Hit { kMiss, kThrough, kUnclear };

Hit hit_of(const Patches& patches, const Patch& patch, const Probe& p) {
    const auto corners = patches.corners_of(patch);
    const Int128 steep = patch.plane.n[static_cast<std::size_t>(p.axis)];
    bool zero = false;
    int seen = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PointId a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
        const int s = turn_of(exact_point(patches.points.grid(a)), exact_point(patches.points.grid(b)), p.point, p.axis);
        zero = zero || s == 0;
        if (s == 0) continue;
        if (steep == 0) return Hit::kMiss;
        if (seen != 0 && s != seen) return Hit::kMiss;
        seen = s;
    }
    return zero ? Hit::kUnclear : Hit::kThrough;
}

}  // namespace

std::optional<std::vector<std::pair<std::uint32_t, int>>> windings_in_front(const Patches& patches, const BoxTree& tree, const SmallFaces& small,
                                                                            const SmallFace& face) {
    const ExactPlane& plane = small.planes[face.plane];
    const int axis = plane.largest_axis();
    const auto k = static_cast<std::size_t>(axis);
    constexpr std::array<std::array<double, 3>, 4> kShares{{{0.34, 0.35, 0.31}, {0.47, 0.29, 0.24}, {0.22, 0.51, 0.27}, {0.13, 0.18, 0.69}}};
    for (const auto& shares : kShares) {
        const auto probe = probe_of(patches, face, axis, shares);
        if (!probe) continue;
        DoubleBox line;
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = std::ldexp(static_cast<double>(probe->x[i]), -kFiner);
            line.lo[i] = x - 1, line.hi[i] = x + 1;
        }
        line.lo[k] = -HUGE_VAL, line.hi[k] = HUGE_VAL;
        const Wide<4> own = height(plane, *probe);
        std::map<std::uint32_t, int> sum;
        bool clear = true;
        tree.touching(line, [&](std::uint32_t i) {
            if (!clear) return;
            const Patch& patch = patches.patches[i];
            const Hit hit = hit_of(patches, patch, *probe);
            clear = hit != Hit::kUnclear;
            if (hit != Hit::kThrough) return;
            const bool up = patch.plane.n[k] > 0, own_up = plane.n[k] > 0;
            const int above = (height(patch.plane, *probe) * Wide<2>(plane.n[k]) - own * Wide<2>(patch.plane.n[k])).sign() * (up == own_up ? 1 : -1);
            if (above > 0) sum[patches.facets[patch.facet].operand] += up ? 1 : -1;
        });
        if (!clear) continue;
        if (plane.n[k] < 0)  // what is above is the back: to the front through the face
            for (const CoverEntry& e : small.covers[face.cover]) sum[patches.facets[e.facet].operand] -= e.sign;
        std::vector<std::pair<std::uint32_t, int>> out;
        for (const auto& [operand, winding] : sum)
            if (winding != 0) out.emplace_back(operand, winding);
        return out;
    }
    return std::nullopt;
}

}  // namespace whittle
