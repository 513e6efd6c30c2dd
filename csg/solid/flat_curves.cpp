#include "csg/solid/flat_curves.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/parabola.h"

namespace whittle {
namespace {

constexpr double kTurn = 6.283185307179586;
// Steps along a curve where another may cross it: ellipses and parabolas cross at most four times.
constexpr int kSteps = 256;
constexpr int kHalvings = 60;
// Of a Bezier curve's parameter: a crossing so near to an end that meets the other curve is that end, seen at a small angle.
constexpr double kSameEnd = 0x1p-20;

double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

// Coordinates of p in the frame where the ellipse is the unit circle.
Vec2 in_frame(const FlatCurve& e, Vec2 p) {
    const Vec2 d = p - e.centre;
    const double det = cross(e.u, e.v);
    return {cross(d, e.v) / det, cross(e.u, d) / det};
}

bool is_circle(const FlatCurve& e) {
    const double uu = glm::dot(e.u, e.u), vv = glm::dot(e.v, e.v);
    return std::fabs(uu - vv) <= 0x1p-48 * uu && std::fabs(glm::dot(e.u, e.v)) <= 0x1p-48 * uu;
}

double distance_to_line(const FlatCurve& l, Vec2 p, double& t) {
    const Vec2 d = l.b - l.a;
    t = std::clamp(glm::dot(p - l.a, d) / glm::dot(d, d), 0.0, 1.0);
    return glm::length(l.a + d * t - p);
}

void ends_on_line(const FlatCurve& l, const FlatCurve& other, double tolerance, std::vector<Vec2>& out) {
    double t = 0;
    for (const Vec2& p : {other.a, other.b})
        if (distance_to_line(l, p, t) <= tolerance) out.push_back(p);
}

void lines(const FlatCurve& p, const FlatCurve& q, double tolerance, std::vector<Vec2>& out) {
    const std::size_t before = out.size();
    ends_on_line(p, q, tolerance, out);
    ends_on_line(q, p, tolerance, out);
    if (out.size() > before) return;
    const Vec2 d = p.b - p.a, e = q.b - q.a, w = q.a - p.a;
    const double det = cross(d, e);
    if (det == 0) return;
    const double t = cross(w, e) / det, s = cross(w, d) / det;
    if (t >= 0 && t <= 1 && s >= 0 && s <= 1) out.push_back(p.a + d * t);
}

void line_ellipse(const FlatCurve& l, const FlatCurve& e, double tolerance, std::vector<Vec2>& out) {
    const Vec2 p = in_frame(e, l.a), d = in_frame(e, l.b) - p;
    const double size = std::sqrt(std::fabs(cross(e.u, e.v))), near = tolerance / size;
    for (const auto& [end, at] : {std::pair(l.a, p), std::pair(l.b, p + d)})
        if (std::fabs(glm::length(at) - 1) <= near) out.push_back(end);
    const double a = glm::dot(d, d), foot_t = -glm::dot(p, d) / a;
    const double gap = glm::length(p + d * foot_t);  // from the centre to the line
    if (gap > 1 + near) return;
    const double half = gap < 1 ? std::sqrt((1 - gap) * (1 + gap) / a) : 0;
    double ignored = 0;
    for (const double t : {foot_t - half, foot_t + half}) {
        const Vec2 q = l.a + (l.b - l.a) * t;
        if (distance_to_line(l, q, ignored) <= tolerance) out.push_back(q);
    }
}

void circles(const FlatCurve& p, const FlatCurve& q, double tolerance, std::vector<Vec2>& out) {
    const double r = glm::length(p.u), s = glm::length(q.u), d = glm::length(q.centre - p.centre);
    if (d <= tolerance || d > r + s + tolerance || d < std::fabs(r - s) - tolerance) return;
    const Vec2 along = (q.centre - p.centre) / d, across{-along.y, along.x};
    const double x = (d * d + (r - s) * (r + s)) / (2 * d), h = std::sqrt(std::max(0.0, (r - x) * (r + x)));
    out.push_back(p.centre + along * x + across * h);
    if (h > 0) out.push_back(p.centre + along * x - across * h);
}

// How far outside q the point of p at t is, in q's frame.
double outside(const FlatCurve& p, const FlatCurve& q, double t) { return glm::length(in_frame(q, p.at(t))) - 1; }

void ellipses(const FlatCurve& p, const FlatCurve& q, double tolerance, std::vector<Vec2>& out) {
    const double near = tolerance / std::sqrt(std::fabs(cross(q.u, q.v)));
    std::vector<double> f(kSteps + 1);
    double largest = 0;
    for (int i = 0; i <= kSteps; ++i) {
        f[static_cast<std::size_t>(i)] = outside(p, q, kTurn * i / kSteps);
        largest = std::max(largest, std::fabs(f[static_cast<std::size_t>(i)]));
    }
    if (largest <= near) return;  // the same ellipse
    for (int i = 0; i < kSteps; ++i) {
        double t0 = kTurn * i / kSteps, t1 = kTurn * (i + 1) / kSteps;
        const bool above = f[static_cast<std::size_t>(i)] > 0;
        if (above == (f[static_cast<std::size_t>(i) + 1] > 0)) continue;
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = (t0 + t1) / 2;
            ((outside(p, q, middle) > 0) == above ? t0 : t1) = middle;
        }
        out.push_back(p.at(t0));
    }
}

// The parameters of a Bezier curve where f of its point changes sign.
template <class F>
std::vector<double> sign_changes(const FlatCurve& p, F f) {
    std::vector<double> out;
    for (int i = 0; i < kSteps; ++i) {
        double t0 = static_cast<double>(i) / kSteps, t1 = static_cast<double>(i + 1) / kSteps;
        const bool above = f(p.at(t0)) > 0;
        if (above == (f(p.at(t1)) > 0)) continue;
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = (t0 + t1) / 2;
            ((f(p.at(middle)) > 0) == above ? t0 : t1) = middle;
        }
        out.push_back(t0);
    }
    return out;
}

// S^2 + D T of tracer/engine's parabolas, here with the curve's own numbers: 0 on it, negative on the side of its focus.
double beyond_parabola(const FlatCurve& q, Vec2 p) {
    const Vec2 e = q.b - q.a, f = q.c - q.a, g = 2.0 * f - e, r = p - q.a;
    const double whole = cross(e, f), across = whole + cross(g, r), along = 2 * cross(e, r) - whole;
    return across * across + whole * along;
}

// On the line, Bezier curve or ellipse, up to the tolerance?
bool is_on(const FlatCurve& q, Vec2 p, double tolerance) {
    if (q.curved) return std::fabs(glm::length(in_frame(q, p)) - 1) * std::sqrt(std::fabs(cross(q.u, q.v))) <= tolerance;
    double t = 0;
    if (!q.quadratic) return distance_to_line(q, p, t) <= tolerance;
    return glm::length(q.at(std::clamp(q.parameter(p), 0.0, 1.0)) - p) <= tolerance;
}

double outside_of(const FlatCurve& q, Vec2 p) {
    if (q.curved) return glm::length(in_frame(q, p)) - 1;
    return q.quadratic ? beyond_parabola(q, p) : cross(q.b - q.a, p - q.a);
}

// p is a Bezier curve, q anything.
void bezier(const FlatCurve& p, const FlatCurve& q, double tolerance, std::vector<Vec2>& out) {
    std::vector<double> ends;
    const auto end = [&](Vec2 at) {
        out.push_back(at);
        ends.push_back(p.parameter(at));
    };
    for (const Vec2& at : {p.a, p.b})
        if (is_on(q, at, tolerance)) end(at);
    if (!q.curved)
        for (const Vec2& at : {q.a, q.b})
            if (is_on(p, at, tolerance)) end(at);
    for (const double t : sign_changes(p, [&](Vec2 at) { return outside_of(q, at); })) {
        const bool is_end = std::any_of(ends.begin(), ends.end(), [&](double e) { return std::fabs(e - t) <= kSameEnd; });
        if (!is_end && is_on(q, p.at(t), tolerance)) out.push_back(p.at(t));
    }
}

std::optional<Placement> inverse_in_plane(const Placement& a) {
    const double det = a.m[0] * a.m[5] - a.m[1] * a.m[4];
    if (det == 0) return std::nullopt;
    Placement out;
    out.m[0] = a.m[5] / det, out.m[1] = -a.m[1] / det, out.m[4] = -a.m[4] / det, out.m[5] = a.m[0] / det;
    out.m[3] = -(out.m[0] * a.m[3] + out.m[1] * a.m[7]);
    out.m[7] = -(out.m[4] * a.m[3] + out.m[5] * a.m[7]);
    return out;
}

Vec2 moved(const Placement& a, Vec2 p) { return Vec2(apply_to_point(a, {p.x, p.y, 0})); }
Vec2 turned(const Placement& a, Vec2 d) { return Vec2(apply_to_direction(a, {d.x, d.y, 0})); }

bool in_shape(const Shape& shape, Vec2 p) {
    if (const auto* s = std::get_if<shape::Disc>(&shape)) return glm::dot(p, p) < s->r * s->r;
    if (const auto* s = std::get_if<shape::ParabolicSegment>(&shape)) return is_inside(*s, p);
    if (const auto* s = std::get_if<shape::Rectangle>(&shape)) return p.x > s->lo.x && p.y > s->lo.y && p.x < s->hi.x && p.y < s->hi.y;
    const auto* s = std::get_if<shape::Polygon>(&shape);
    if (!s) return false;
    bool inside = false;
    for (const auto& ring : *s->contours)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
            if ((a.y <= p.y) == (b.y <= p.y)) continue;
            inside ^= (cross(b - a, p - a) > 0) == (b.y > a.y);
        }
    return inside;
}

}  // namespace

Vec2 FlatCurve::at(double t) const {
    if (quadratic) return parabola_point({a, c, b}, t);
    return curved ? centre + u * std::cos(t) + v * std::sin(t) : a + (b - a) * t;
}
Vec2 FlatCurve::along(double t) const {
    if (quadratic) return (c - a) * (1 - t) + (b - c) * t;
    return curved ? v * std::cos(t) - u * std::sin(t) : b - a;
}
Vec2 FlatCurve::control(double t0, double t1) const {
    return a * ((1 - t0) * (1 - t1)) + c * ((1 - t0) * t1 + (1 - t1) * t0) + b * (t0 * t1);
}
double FlatCurve::last() const { return curved ? kTurn : 1; }
double FlatCurve::parameter(Vec2 p) const {
    if (quadratic) {
        const Vec2 axis = (b - a) - 2.0 * (c - a);
        return cross(p - a, axis) / (2 * cross(c - a, b - a));
    }
    if (!curved) return glm::dot(p - a, b - a) / glm::dot(b - a, b - a);
    const Vec2 q = in_frame(*this, p);
    const double t = std::atan2(q.y, q.x);
    return t < 0 ? t + kTurn : t;
}

FlatCurve flat_line(Vec2 a, Vec2 b) {
    FlatCurve c;
    c.a = a, c.b = b;
    c.lo = glm::min(a, b), c.hi = glm::max(a, b);
    return c;
}

FlatCurve flat_parabola(Vec2 a, Vec2 c, Vec2 b) {
    FlatCurve p = flat_line(a, b);
    p.quadratic = true;
    p.c = c;
    p.lo = glm::min(p.lo, c), p.hi = glm::max(p.hi, c);
    return p;
}

FlatCurve flat_ellipse(Vec2 centre, Vec2 u, Vec2 v) {
    FlatCurve c;
    c.curved = true;
    c.centre = centre, c.u = u, c.v = v;
    const Vec2 reach{std::hypot(u.x, v.x), std::hypot(u.y, v.y)};
    c.lo = centre - reach, c.hi = centre + reach;
    return c;
}

void meetings(const FlatCurve& p, const FlatCurve& q, double tolerance, std::vector<Vec2>& out) {
    if (p.lo.x > q.hi.x + tolerance || q.lo.x > p.hi.x + tolerance || p.lo.y > q.hi.y + tolerance || q.lo.y > p.hi.y + tolerance) return;
    if (p.quadratic) return bezier(p, q, tolerance, out);
    if (q.quadratic) return bezier(q, p, tolerance, out);
    if (!p.curved && !q.curved) return lines(p, q, tolerance, out);
    if (!p.curved) return line_ellipse(p, q, tolerance, out);
    if (!q.curved) return line_ellipse(q, p, tolerance, out);
    if (is_circle(p) && is_circle(q)) return circles(p, q, tolerance, out);
    ellipses(p, q, tolerance, out);
}

FlatSet::FlatSet(const Solid& solid, const Use& use) { root_ = add(solid, use.node, use.placement); }

std::uint32_t FlatSet::add(const Solid& solid, NodeId id, const Placement& placement) {
    Node node{};
    if (const auto* c = std::get_if<Combination>(&solid.node(id))) {
        node.op = c->op;
        for (const Use& use : c->operands) node.operands.push_back(add(solid, use.node, placement * use.placement));
    } else {
        const auto& shape = std::get<Shape>(solid.node(id));
        const std::size_t first = curves_.size();
        if (const auto* s = std::get_if<shape::Disc>(&shape)) curves_.push_back(flat_ellipse(moved(placement, Vec2(0)), turned(placement, {s->r, 0}), turned(placement, {0, s->r})));
        if (const auto* s = std::get_if<shape::ParabolicSegment>(&shape)) {
            const FlatCurve arc = flat_parabola(moved(placement, s->a), moved(placement, s->c), moved(placement, s->b));
            curves_.push_back(flat_line(arc.a, arc.b));
            curves_.push_back(arc);
        }
        std::vector<std::vector<Vec2>> rings;
        if (const auto* s = std::get_if<shape::Rectangle>(&shape)) rings = {{s->lo, {s->hi.x, s->lo.y}, s->hi, {s->lo.x, s->hi.y}}};
        if (const auto* s = std::get_if<shape::Polygon>(&shape)) rings = *s->contours;
        for (const auto& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Vec2 a = moved(placement, ring[i]), b = moved(placement, ring[(i + 1) % ring.size()]);
                if (a != b) curves_.push_back(flat_line(a, b));
            }
        const auto inverse = inverse_in_plane(placement);
        Leaf leaf{&shape, inverse.value_or(Placement{}), Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
        for (std::size_t i = first; inverse && i < curves_.size(); ++i) leaf.lo = glm::min(leaf.lo, curves_[i].lo), leaf.hi = glm::max(leaf.hi, curves_[i].hi);
        node.is_leaf = true;
        node.leaf = static_cast<std::uint32_t>(leaves_.size());
        leaves_.push_back(leaf);
    }
    nodes_.push_back(std::move(node));
    return static_cast<std::uint32_t>(nodes_.size() - 1);
}

bool FlatSet::contains(Vec2 p) const { return contains(root_, p); }

bool FlatSet::contains(std::uint32_t id, Vec2 p) const {
    const Node& node = nodes_[id];
    if (node.is_leaf) {
        const Leaf& leaf = leaves_[node.leaf];
        if (p.x < leaf.lo.x || p.y < leaf.lo.y || p.x > leaf.hi.x || p.y > leaf.hi.y) return false;
        return in_shape(*leaf.shape, moved(leaf.inverse, p));
    }
    const auto inside = [&](std::uint32_t operand) { return contains(operand, p); };
    if (node.op == SetOp::kUnion) return std::any_of(node.operands.begin(), node.operands.end(), inside);
    if (node.op == SetOp::kIntersection) return !node.operands.empty() && std::all_of(node.operands.begin(), node.operands.end(), inside);
    return !node.operands.empty() && inside(node.operands[0]) && std::none_of(node.operands.begin() + 1, node.operands.end(), inside);
}

}  // namespace whittle
