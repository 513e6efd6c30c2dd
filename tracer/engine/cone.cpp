#include "tracer/engine/cone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <sleef.h>

#include "tracer/engine/program.h"

namespace whittle {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// More half-spaces than this about one cone: no single edge stands for what is there.
constexpr std::size_t kMostSides = 96;

// A root this near to the hit, relative to it, is the hit.
constexpr double kSameDepth = 1e-9;

double value(const LinePolynomial<double>& p, double t) {
    double sum = 0;
    for (int i = p.degree; i >= 0; --i) sum = sum * t + p.c[static_cast<std::size_t>(i)];
    return sum;
}

// A half-space about the cone: its polynomial on the axis and on four lines along the cone's rim.
struct Side {
    std::uint32_t packed = 0;
    LinePolynomial<double> axis;
    std::array<LinePolynomial<double>, 4> rim;  // +u, -u, +v, -v

    bool inside(double t) const { return (packed & 1) != 0 ? value(axis, t) >= 0 : value(axis, t) <= 0; }
};

// Where the edge of a side lies in the section at t: `offset` from the axis in radii (negative: the axis is outside), outward along (u, v).
struct EdgePlace {
    double offset = 0;
    double u = 0, v = 0;
    double t = 0;
};

std::optional<EdgePlace> edge_place(const Side& side, double t) {
    const double gu = 0.5 * (value(side.rim[0], t) - value(side.rim[1], t)), gv = 0.5 * (value(side.rim[2], t) - value(side.rim[3], t));
    const double slope = std::sqrt(gu * gu + gv * gv);
    if (!(slope > 0)) return std::nullopt;
    const double sign = (side.packed & 1) != 0 ? -1 : 1;
    return EdgePlace{-sign * value(side.axis, t) / slope, sign * gu / slope, sign * gv / slope, t};
}

// The little formula about one cone: groups and leaves that it may meet.
struct Part {
    bool leaf = false;
    bool is_and = false;
    bool negated = false;
    bool constant = false, constant_value = false;
    std::size_t first = 0, count = 0;  // of `children`
};

class ConeFormula {
public:
    ConeFormula(const Program& program, const Cone& cone, double t_most) : program_(program), cone_(cone), t_most_(t_most) {
        const Vec3 d = cone.axis.direction;
        const Vec3 other = std::abs(d.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        u = glm::normalize(glm::cross(d, other));
        v = glm::cross(d, u);
        slab_ = slab_ray({cone.axis.origin.x, cone.axis.origin.y, cone.axis.origin.z}, {d.x, d.y, d.z});
        root_ = gather(program.root);
    }

    // False: something is here that cones do not divide.
    bool readable() const { return readable_ && sides.size() <= kMostSides; }
    // Is the axis's point at t inside, with sides `a` and `b` (indices, or none) on the given sides?
    bool inside(double t, std::size_t a, bool a_inside, std::size_t b, bool b_inside) const { return part_inside(root_, t, a, a_inside, b, b_inside); }
    bool departs_from(const Side& side) const {
        const Departure* d = cone_.axis.departure;
        return d && std::find(d->classes.begin(), d->classes.begin() + d->count, side.packed >> 1) != d->classes.begin() + d->count;
    }

    std::vector<Side> sides;
    Vec3 u{0}, v{0};
    static constexpr std::size_t kNone = ~std::size_t{0};

private:
    // Does the cone come near the box? Grown by the radius where the cone is widest near it.
    template <class Lo>
    bool meets(const Lo& lo, const Lo& hi) const {
        double far2 = 0;
        for (int i = 0; i < 3; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const double reach = std::max(std::abs(static_cast<double>(lo[k]) - cone_.axis.origin[i]), std::abs(static_cast<double>(hi[k]) - cone_.axis.origin[i]));
            far2 += reach * reach;
        }
        const double radius = cone_.start + cone_.spread * std::min(std::sqrt(far2), t_most_);
        if (!std::isfinite(radius)) return true;
        std::array<double, 3> low, high;
        for (std::size_t k = 0; k < 3; ++k) low[k] = static_cast<double>(lo[k]) - radius, high[k] = static_cast<double>(hi[k]) + radius;
        double from = 0, to = 0;
        return slab_interval(low, high, slab_, from, to) && to >= 0 && from <= t_most_;
    }
    bool meets(const Bounds& b) const { return meets(std::array<double, 3>{b.lo.x, b.lo.y, b.lo.z}, std::array<double, 3>{b.hi.x, b.hi.y, b.hi.z}); }

    std::size_t add(const Part& part) {
        parts_.push_back(part);
        return parts_.size() - 1;
    }

    std::size_t gather(Ref ref) {
        if (!readable_ || sides.size() > kMostSides) return add({});
        return ref.is_leaf() ? gather_leaf(program_.leaves[ref.index()]) : gather_group(program_.groups[ref.index()]);
    }

    std::size_t gather_leaf(const Leaf& leaf) {
        if (leaf.kind != FormulaKind::kCell) {
            const bool whole = leaf.kind == FormulaKind::kEverything;
            if (leaf.kind != FormulaKind::kNothing && !whole) readable_ = false;
            return add({true, false, false, true, whole != leaf.negated, 0, 0});
        }
        Part part{true, true, leaf.negated, false, false, 0, leaf.count};
        std::vector<std::size_t> own;
        for (std::uint32_t i = 0; i < leaf.count; ++i) own.push_back(side_of(program_.half_spaces[leaf.first + i]));
        part.first = children_.size();
        children_.insert(children_.end(), own.begin(), own.end());
        return add(part);
    }

    std::size_t gather_group(const Group& group) {
        if (group.bounded && !meets(group.box)) return add({true, false, false, true, group.outside_value, 0, 0});
        std::vector<std::size_t> own;
        for (std::uint32_t i = 0; i < group.plain_count; ++i) own.push_back(gather(program_.refs[group.first_plain + i]));
        if (group.item_count > 0) gather_items(group, group.hierarchy, own);
        Part part{false, group.is_and, false, false, false, children_.size(), own.size()};
        children_.insert(children_.end(), own.begin(), own.end());
        return add(part);
    }

    void gather_items(const Group& group, std::uint32_t at, std::vector<std::size_t>& own) {
        const BoxNode& node = program_.nodes[at];
        if (!meets(node.lo, node.hi)) return;
        if (node.count == 0) {
            gather_items(group, node.first, own);
            gather_items(group, node.first + 1, own);
            return;
        }
        for (std::uint32_t i = 0; i < node.count; ++i) {
            const Ref ref = program_.refs[node.first + i];
            if (ref.is_leaf()) {
                const FloatBox& box = program_.leaf_boxes[ref.index()];
                if (!meets(box.lo, box.hi)) continue;
            }
            own.push_back(gather(ref));
        }
    }

    std::size_t side_of(HalfSpace half_space) {
        for (std::size_t i = 0; i < sides.size(); ++i)
            if (sides[i].packed == half_space.packed) return i;
        const Support& support = program_.classes[half_space.id()];
        const Frame& frame = program_.frames[support.frame];
        if (frame.motion != 0) readable_ = false;
        Side side;
        side.packed = half_space.packed;
        if (is_turned(support.kind)) {
            readable_ = false;
            sides.push_back(side);
            return sides.size() - 1;
        }
        const auto along = [&](Vec3 off) {
            const Vec3 o = cone_.axis.origin + cone_.start * off;
            return support_polynomial(support, line_in_frame<double>(frame, {o.x, o.y, o.z}, cone_.axis.direction + cone_.spread * off));
        };
        side.axis = along(Vec3(0));
        side.rim = {along(u), along(-u), along(v), along(-v)};
        sides.push_back(side);
        return sides.size() - 1;
    }

    bool part_inside(std::size_t at, double t, std::size_t a, bool a_inside, std::size_t b, bool b_inside) const {
        const Part& part = parts_[at];
        if (part.constant) return part.constant_value;
        bool all = true, any = false;
        for (std::size_t i = 0; i < part.count; ++i) {
            const std::size_t child = children_[part.first + i];
            bool in = false;
            if (!part.leaf) in = part_inside(child, t, a, a_inside, b, b_inside);
            else if (child == a) in = a_inside;
            else if (child == b) in = b_inside;
            else in = sides[child].inside(t);
            all = all && in;
            any = any || in;
        }
        return (part.is_and ? all : any) != part.negated;
    }

    const Program& program_;
    const Cone& cone_;
    double t_most_;
    SlabRay slab_;
    std::vector<Part> parts_;
    std::vector<std::size_t> children_;
    std::size_t root_ = 0;
    bool readable_ = true;
};

// Roots of the polynomial, and where it turns around (a quadratic's vertex). Of a quartic neither: tori have no edges here.
struct Places {
    std::array<double, 2> roots{kInfinity, kInfinity};
    double turn = kInfinity;
};

Places places_of(const LinePolynomial<double>& p) {
    Places places;
    if (p.degree == 1 && p.c[1] != 0) places.roots[0] = -p.c[0] / p.c[1];
    if (p.degree != 2 || p.c[2] == 0) return places;
    places.turn = -0.5 * p.c[1] / p.c[2];
    const double rest = places.turn * places.turn - p.c[0] / p.c[2];
    if (rest >= 0) places.roots = {places.turn - std::sqrt(rest), places.turn + std::sqrt(rest)};
    return places;
}

// The edge nearest to the axis.
class EdgeSearch {
public:
    EdgeSearch(const ConeFormula& formula, double t_hit) : formula_(formula), t_most_(t_hit * (1 + kSameDepth)) {}

    void look_at(std::size_t own) {
        if (formula_.departs_from(formula_.sides[own])) return;
        const Places places = places_of(formula_.sides[own].axis);
        for (double t : places.roots)
            if (t > 0 && t <= t_most_) ends_of_face(own, t);
        const bool first_seen = places.roots[0] < kInfinity ? places.roots[0] <= t_most_ : places.turn <= t_most_;
        if (places.turn > 0 && places.turn < kInfinity && first_seen) silhouette(own, places.turn);
    }

    std::optional<EdgePlace> nearest;

private:
    // On the face `own` at t: does it begin or end at another side?
    void ends_of_face(std::size_t own, double t) {
        const auto on_face = [&](std::size_t other, bool in) {
            return formula_.inside(t, own, true, other, in) != formula_.inside(t, own, false, other, in);
        };
        for (std::size_t k = 0; k < formula_.sides.size(); ++k) {
            if (k == own) continue;
            const std::optional<EdgePlace> place = edge_place(formula_.sides[k], t);
            if (place && near(*place) && on_face(k, true) != on_face(k, false)) nearest = place;
        }
    }

    void silhouette(std::size_t own, double t) {
        const std::optional<EdgePlace> place = edge_place(formula_.sides[own], t);
        if (place && near(*place) && formula_.inside(t, own, true, ConeFormula::kNone, false) != formula_.inside(t, own, false, ConeFormula::kNone, false)) nearest = place;
    }

    bool near(const EdgePlace& place) const { return std::abs(place.offset) < (nearest ? std::abs(nearest->offset) : 1.0); }

    const ConeFormula& formula_;
    double t_most_;
};

}  // namespace

DiscCut cut_disc(double offset) {
    const double a = std::clamp(offset, 0.0, 1.0), half = std::sqrt(1 - a * a);
    const double area = Sleef_cinz_acosd1_u10purec(a) - a * half;
    if (!(area > 0)) return {0, 1};
    return {area / kPi, 2.0 / 3 * half * half * half / area};
}

ConeSplit split_cone(const Program& program, const Cone& cone, double t_hit) {
    ConeSplit split;
    if (program.empty || program.everything) return split;
    const ConeFormula formula(program, cone, t_hit);
    if (!formula.readable()) return split;
    EdgeSearch search(formula, t_hit);
    for (std::size_t own = 0; own < formula.sides.size(); ++own) search.look_at(own);
    if (!search.nearest) return split;
    const EdgePlace& edge = *search.nearest;
    const DiscCut cut = cut_disc(std::abs(edge.offset));
    if (!(cut.share > 0)) return split;
    // Towards the edge: outward where the axis is inside.
    const Vec3 towards = (edge.offset >= 0 ? 1.0 : -1.0) * (edge.u * formula.u + edge.v * formula.v);
    split.share = 1 - cut.share;
    split.t = edge.t;
    split.there = cut.centroid * towards;
    split.here = -cut.centroid * cut.share / (1 - cut.share) * towards;
    return split;
}

}  // namespace whittle
