#include "tracer/engine/cone_formula.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

namespace whittle {

namespace {

// More half-spaces than this about one cone: no few edges stand for what is there.
constexpr std::size_t kMostSides = 96;

constexpr double kPi = 3.14159265358979323846;

// Points of the disc with (x, y) . (u, v) <= most.
std::uint64_t points_below(double u, double v, double most) {
    const auto& points = disc_points();
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i < kDiscPoints; ++i) mask |= std::uint64_t{points[i].x * u + points[i].y * v <= most} << i;
    return mask;
}

std::array<double, 2> across(Vec3 w, Vec3 u, Vec3 v) { return {glm::dot(w, u), glm::dot(w, v)}; }

}  // namespace

// Of a spiral that turns by the golden angle.
const std::array<DiscPoint, kDiscPoints>& disc_points() {
    static const std::array<DiscPoint, kDiscPoints> points = [] {
        std::array<DiscPoint, kDiscPoints> all{};
        for (int i = 0; i < kDiscPoints; ++i) {
            const double radius = std::sqrt((i + 0.5) / kDiscPoints);
            const Sleef_double_2 turn = Sleef_cinz_sincosd1_u10purec(i * kPi * (3 - std::sqrt(5.0)));
            all[static_cast<std::size_t>(i)] = {radius * turn.y, radius * turn.x};
        }
        return all;
    }();
    return points;
}

namespace {

// To the farthest corner of the box around all; of what has no end no length is better than another.
double way_past(const Program& program, const Vec3& from) {
    Vec3 way;
    for (int i = 0; i < 3; ++i) way[i] = std::max(std::abs(program.bounds.lo[i] - from[i]), std::abs(program.bounds.hi[i] - from[i]));
    const double length = glm::length(way);
    return std::isfinite(length) ? length : 1;
}

}  // namespace

bool ConeFormula::read(const Program& program, const Cone& cone, double t_most) {
    program_ = &program;
    cone_ = &cone;
    t_most_ = t_most;
    const Vec3 d = cone.axis.direction, o = cone.axis.origin;
    const Vec3 other = std::abs(glm::dot(d, cone.right)) < 0.5 ? cone.right : cone.up;
    u = glm::normalize(glm::cross(d, other));
    v = glm::cross(d, u);
    near_u_ = across(cone.near_u, u, v), near_v_ = across(cone.near_v, u, v);
    far_u_ = across(cone.far_u, u, v), far_v_ = across(cone.far_v, u, v);
    near_size_ = std::sqrt(glm::dot(cone.near_u, cone.near_u) + glm::dot(cone.near_v, cone.near_v));
    far_size_ = std::sqrt(glm::dot(cone.far_u, cone.far_u) + glm::dot(cone.far_v, cone.far_v));
    step_ = std::max({cone.start + cone.spread * std::min(t_most, way_past(program, o)), near_size_, far_size_});
    if (!(step_ > 0) || !std::isfinite(step_)) return false;
    slab_ = slab_ray({o.x, o.y, o.z}, {d.x, d.y, d.z});
    sides.clear();
    edges.clear();
    lines_.clear();
    parts_.clear();
    children_.clear();
    pending_.clear();
    readable_ = true;
    root_ = gather(program.root);
    return readable_ && sides.size() <= kMostSides;
}

ConeSection ConeFormula::section(double t) const {
    const double radius = cone_->start + cone_->spread * t, share = std::min(1.0, t / cone_->reach), rest = 1 - share;
    double uu = radius * radius, uv = 0, vv = uu;
    const auto add = [&](const std::array<double, 2>& w, double scale) {
        uu += scale * scale * w[0] * w[0];
        uv += scale * scale * w[0] * w[1];
        vv += scale * scale * w[1] * w[1];
    };
    add(near_u_, rest), add(near_v_, rest), add(far_u_, share), add(far_v_, share);
    // The root of the sum of squares, symmetric.
    const double det = std::sqrt(std::max(0.0, uu * vv - uv * uv)), scale = 1 / std::sqrt(std::max(uu + vv + 2 * det, 1e-300));
    return {(uu + det) * scale, uv * scale, (vv + det) * scale};
}

ConeEdge ConeFormula::edge(std::size_t side, const ConeSection& section, const Leaning& plane) const {
    const ConeSide& s = sides[side];
    const double t = plane.t, along = slope_at(s.axis, t), value = s.inside_sign() * value_at(s.axis, t);
    const double gu = value_at(s.along_u, t) + along * plane.u, gv = value_at(s.along_v, t) + along * plane.v;
    const double wu = section.uu * gu + section.uv * gv, wv = section.uv * gu + section.vv * gv, slope2 = wu * wu + wv * wv;
    if (!(value * value < slope2)) return {value <= 0 ? 2.0 : -2.0, 0, 0, t, value <= 0 ? ~std::uint64_t{0} : 0};
    const double scale = 1 / std::sqrt(slope2);
    ConeEdge edge{-scale * value, s.inside_sign() * scale * wu, s.inside_sign() * scale * wv, t, 0};
    edge.mask = points_below(edge.u, edge.v, edge.offset);
    return edge;
}

std::uint64_t ConeFormula::points_ahead(const ConeSection& section, const Leaning& plane) const {
    const double wu = section.uu * plane.u + section.uv * plane.v, wv = section.uv * plane.u + section.vv * plane.v, lean2 = wu * wu + wv * wv;
    if (!(lean2 > plane.t * plane.t)) return ~std::uint64_t{0};
    return points_below(-wu, -wv, plane.t) & points_below(wu, wv, plane.t);
}

std::uint64_t ConeFormula::face(std::size_t own, const Leaning& plane) {
    const ConeSection here = section(plane.t);
    masks_.resize(sides.size());
    std::uint64_t reached = points_ahead(here, plane);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const ConeSide& side = sides[i];
        if (i == own) continue;
        if (side.class_id() == sides[own].class_id()) continue;  // its other side: in its own plane it has no edge
        const ConeEdge found = edge(i, here, plane);
        masks_[i] = found.mask;
        if (side.departs) reached &= side.inside_sign() * side.axis.c[1] <= 0 ? found.mask : ~found.mask;
        else if (std::abs(found.offset) < 1) edges.push_back(found);
    }
    return (inside(root_, own, ~std::uint64_t{0}) ^ inside(root_, own, 0)) & reached;
}

// Does the cone come near the box? Grown by the radius where the cone is widest near it.
template <class Lo>
bool ConeFormula::meets(const Lo& lo, const Lo& hi) const {
    double far2 = 0;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double reach = std::max(std::abs(static_cast<double>(lo[k]) - cone_->axis.origin[i]), std::abs(static_cast<double>(hi[k]) - cone_->axis.origin[i]));
        far2 += reach * reach;
    }
    const double t = std::min(std::sqrt(far2), t_most_);
    const double radius = cone_->start + cone_->spread * t + near_size_ + far_size_ * std::min(1.0, t / cone_->reach);
    if (!std::isfinite(radius)) return true;
    std::array<double, 3> low, high;
    for (std::size_t k = 0; k < 3; ++k) low[k] = static_cast<double>(lo[k]) - radius, high[k] = static_cast<double>(hi[k]) + radius;
    double from = 0, to = 0;
    return slab_interval(low, high, slab_, from, to) && to >= 0 && from <= t_most_;
}

bool ConeFormula::meets(const Bounds& b) const { return meets(std::array<double, 3>{b.lo.x, b.lo.y, b.lo.z}, std::array<double, 3>{b.hi.x, b.hi.y, b.hi.z}); }

std::size_t ConeFormula::add(const Part& part) {
    parts_.push_back(part);
    return parts_.size() - 1;
}

std::size_t ConeFormula::add_with_children(Part part, std::size_t base) {
    part.first = children_.size();
    part.count = pending_.size() - base;
    children_.insert(children_.end(), pending_.begin() + static_cast<std::ptrdiff_t>(base), pending_.end());
    pending_.resize(base);
    return add(part);
}

std::size_t ConeFormula::gather(Ref ref) {
    if (!readable_ || sides.size() > kMostSides) return constant(false);
    return ref.is_leaf() ? gather_leaf(program_->leaves[ref.index()]) : gather_group(program_->groups[ref.index()]);
}

std::size_t ConeFormula::gather_leaf(const Leaf& leaf) {
    if (leaf.kind != FormulaKind::kCell) {
        const bool whole = leaf.kind == FormulaKind::kEverything;
        if (leaf.kind != FormulaKind::kNothing && !whole) readable_ = false;
        return constant(whole != leaf.negated);
    }
    const std::size_t base = pending_.size();
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        const std::size_t side = side_of(program_->half_spaces[leaf.first + i]);
        pending_.push_back(side);
    }
    return add_with_children({true, true, leaf.negated, false, false, 0, 0}, base);
}

std::size_t ConeFormula::gather_group(const Group& group) {
    if (group.bounded && !meets(group.box)) return constant(group.outside_value);
    const std::size_t base = pending_.size();
    for (std::uint32_t i = 0; i < group.plain_count; ++i) {
        const std::size_t part = gather(program_->refs[group.first_plain + i]);
        pending_.push_back(part);
    }
    if (group.item_count > 0) gather_items(group.wide);
    return add_with_children({false, group.is_and, false, false, false, 0, 0}, base);
}

void ConeFormula::gather_items(std::uint32_t at) {
    const WideNode& node = program_->wide[at];
    for (std::uint32_t k = 0; k < node.count; ++k) {
        std::array<float, 3> lo, hi;
        for (std::size_t i = 0; i < 3; ++i) lo[i] = node.side[0][i][k], hi[i] = node.side[1][i][k];
        if (!meets(lo, hi)) continue;
        if (!node.child[k].is_item()) {
            gather_items(node.child[k].index());
            continue;
        }
        const Ref ref = program_->refs[node.child[k].index()];
        // The node's boxes are single, and wider than the part where it stands far out.
        if (ref.is_leaf() && !program_->leaf_bounds.empty() && !meets(program_->leaf_bounds[ref.index()])) continue;
        const std::size_t part = gather(ref);
        pending_.push_back(part);
    }
}

const ConeFormula::FrameLines& ConeFormula::lines_in(std::uint32_t frame) {
    for (const FrameLines& known : lines_)
        if (known.frame == frame) return known;
    const auto line = [&](Vec3 origin, Vec3 direction) { return line_in_frame<double>(program_->frames[frame], {origin.x, origin.y, origin.z}, direction); };
    const FrameLine<double> axis = line(cone_->axis.origin, cone_->axis.direction);
    // The step goes through the frame as a direction: beside a far origin it would lose its digits.
    const auto beside = [&](Vec3 across, double step) {
        const FrameLine<double> towards = line(cone_->axis.origin, across);
        FrameLine<double> moved = axis;
        for (std::size_t i = 0; i < 3; ++i) moved.o[i] += step * towards.d[i];
        return moved;
    };
    lines_.push_back({frame, axis, {beside(u, step_), beside(u, -step_), beside(v, step_), beside(v, -step_)}});
    return lines_.back();
}

std::size_t ConeFormula::side_of(HalfSpace half_space) {
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (sides[i].packed == half_space.packed) return i;
    const Support& support = program_->classes[half_space.id()];
    sides.push_back({half_space.packed, names(cone_->axis.departure, half_space.id()), {}, {}, {}});
    if (program_->frames[support.frame].motion != 0 || !has_polynomial(support.kind)) {
        readable_ = false;
        return sides.size() - 1;
    }
    const FrameLines& lines = lines_in(support.frame);
    // Central differences: exact for planes and quadrics.
    const auto slope = [&](std::size_t ahead, std::size_t back) {
        LinePolynomial<double> p = support_polynomial(support, lines.beside[ahead]);
        const LinePolynomial<double> q = support_polynomial(support, lines.beside[back]);
        for (std::size_t i = 0; i <= static_cast<std::size_t>(p.degree); ++i) p.c[i] = (p.c[i] - q.c[i]) / (2 * step_);
        while (p.degree > 0 && p.c[static_cast<std::size_t>(p.degree)] == 0) --p.degree;
        return p;
    };
    ConeSide& side = sides.back();
    side.axis = support_polynomial(support, lines.axis);
    side.along_u = slope(0, 1);
    side.along_v = slope(2, 3);
    return sides.size() - 1;
}

std::uint64_t ConeFormula::inside_side(std::size_t side, std::size_t own, std::uint64_t own_mask) const {
    if (side == own) return own_mask;
    return sides[side].class_id() == sides[own].class_id() ? ~own_mask : masks_[side];
}

std::uint64_t ConeFormula::inside(std::size_t at, std::size_t own, std::uint64_t own_mask) const {
    const Part& part = parts_[at];
    const std::uint64_t all = ~std::uint64_t{0};
    if (part.constant) return part.constant_value ? all : 0;
    std::uint64_t mask = part.is_and ? all : 0;
    for (std::size_t i = 0; i < part.count && mask != (part.is_and ? 0 : all); ++i) {
        const std::size_t child = children_[part.first + i];
        const std::uint64_t in = !part.leaf ? inside(child, own, own_mask) : inside_side(child, own, own_mask);
        mask = part.is_and ? mask & in : mask | in;
    }
    return part.negated ? ~mask : mask;
}

}  // namespace whittle
