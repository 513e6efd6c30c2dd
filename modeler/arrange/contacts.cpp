#include "modeler/arrange/contacts.h"

#include <algorithm>
#include <optional>

namespace whittle {
namespace {

using Located = PointTable::Located;

// The corners' sides of a plane, and whether the piece meets it.
struct Sides {
    std::vector<int> of;
    bool below = false, above = false, on = false;
    bool more_than_two_on() const { return std::count(of.begin(), of.end(), 0) > 2; }
    bool meets() const { return on || (below && above); }
    bool within() const { return !below && !above; }
};

void find_sides(const Patches& patches, const Patch& patch, const ExactPlane& plane, Sides& out) {
    out.of.clear();
    out.below = out.above = out.on = false;
    for (const PointId c : patches.corners_of(patch)) {
        const int s = side_of(plane, patches.points.grid(c));
        out.of.push_back(s);
        (s < 0 ? out.below : s > 0 ? out.above : out.on) = true;
    }
}

// An axis along which the common line of two planes runs.
int line_axis(const ExactPlane& p, const ExactPlane& q) {
    int best = -1;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double one = p.nd[j] * q.nd[k], two = p.nd[k] * q.nd[j], c = std::fabs(one - two);
        constexpr double kProductError = 0x1p-50;
        if (c > kProductError * (std::fabs(one) + std::fabs(two)) && c > most) most = c, best = static_cast<int>(i);
    }
    if (best >= 0) return best;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        if ((Wide<2>(p.n[j]) * Wide<2>(q.n[k]) - Wide<2>(p.n[k]) * Wide<2>(q.n[j])).sign() != 0) return static_cast<int>(i);
    }
    return 0;
}

struct Interval {
    std::optional<Located> lo, hi;
};

// Of a convex piece on the line in which its plane meets another.
Interval interval_of(const Patches& patches, const Patch& patch, const ExactPlane& plane, const Sides& sides, int axis) {
    Interval out;
    const auto corners = patches.corners_of(patch);
    const auto put = [&](const Located& p) {
        if (!out.lo || PointTable::compare(p, *out.lo, axis) < 0) out.lo = p;
        if (!out.hi || PointTable::compare(p, *out.hi, axis) > 0) out.hi = p;
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t j = i + 1 == corners.size() ? 0 : i + 1;
        const GridPoint a = patches.points.grid(corners[i]);
        if (sides.of[i] == 0) put(PointTable::located(a));
        if (sides.of[i] * sides.of[j] < 0) put(PointTable::located(crossing_of(a, patches.points.grid(corners[j]), plane)));
    }
    return out;
}

}  // namespace

Contact contact_of(Patches& patches, const Patch& a, const Patch& b) {
    thread_local Sides of_a, of_b;
    find_sides(patches, a, b.plane, of_a);
    if (!of_a.meets()) return {};
    if (of_a.within()) return {Contact::Kind::kCoplanar, 0, 0, false, false};
    find_sides(patches, b, a.plane, of_b);
    if (!of_b.meets()) return {};
    const int axis = line_axis(a.plane, b.plane);
    const Interval p = interval_of(patches, a, b.plane, of_a, axis), q = interval_of(patches, b, a.plane, of_b, axis);
    if (!p.lo || !q.lo) return {};
    const Located& lo = PointTable::compare(*p.lo, *q.lo, axis) >= 0 ? *p.lo : *q.lo;
    const Located& hi = PointTable::compare(*p.hi, *q.hi, axis) <= 0 ? *p.hi : *q.hi;
    const int order = PointTable::compare(lo, hi, axis);
    if (order > 0) return {};
    const PointId from = patches.points.add(lo);
    if (order == 0) return {Contact::Kind::kPoint, from, from, false, false};
    return {Contact::Kind::kSegment, from, patches.points.add(hi), of_a.more_than_two_on(), of_b.more_than_two_on()};
}

}  // namespace whittle
