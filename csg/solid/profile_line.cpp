#include "csg/solid/profile_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/solid/use_of.h"

namespace whittle {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

LineIntervals one(double from, double to) { return from < to ? LineIntervals{{from, to}} : LineIntervals(); }

struct IntervalsIn {
    const ProfileLine& line;

    double at(const Vec2& p) const { return glm::dot(p - line.o, line.d) / glm::dot(line.d, line.d); }

    std::optional<LineIntervals> operator()(const shape::Disc& s) {
        const double length = glm::length(line.d), off = std::fabs(cross(line.o, line.d)) / length;
        if (!(off < s.r)) return LineIntervals();
        const double half = std::sqrt((s.r - off) * (s.r + off)) / length, middle = -glm::dot(line.o, line.d) / (length * length);
        return one(middle - half, middle + half);
    }
    std::optional<LineIntervals> operator()(const shape::Rectangle& s) { return (*this)(std::vector<std::vector<Vec2>>{{s.lo, {s.hi.x, s.lo.y}, s.hi, {s.lo.x, s.hi.y}}}); }
    std::optional<LineIntervals> operator()(const shape::Polygon& s) { return s.section == kEmptyNode ? (*this)(*s.contours) : std::nullopt; }

    // By parity. A corner on the line is below it.
    std::optional<LineIntervals> operator()(const std::vector<std::vector<Vec2>>& contours) {
        std::vector<double> crossings;
        for (const auto& ring : contours)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
                const double from = glm::dot(line.up, a - line.o), to = glm::dot(line.up, b - line.o);
                if ((from > 0) != (to > 0)) crossings.push_back(at(a + (b - a) * (from / (from - to))));
            }
        std::sort(crossings.begin(), crossings.end());
        LineIntervals in;
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            if (crossings[i] < crossings[i + 1]) in.push_back({crossings[i], crossings[i + 1]});
        return in;
    }

    // With weights u, v, w of a, c, b the segment is v >= 0, v^2 <= 4 u w: along the line a linear and a quadratic, whose leading coefficient is (u' - w')^2.
    std::optional<LineIntervals> operator()(const shape::ParabolicSegment& s) {
        const Vec2 c = s.c - s.a, b = s.b - s.a, o = line.o - s.a;
        const double whole = cross(c, b);
        const double v0 = cross(o, b) / whole, v1 = cross(line.d, b) / whole, w0 = cross(c, o) / whole, w1 = cross(c, line.d) / whole, u0 = 1 - v0 - w0, u1 = -v1 - w1;
        const double q2 = (u1 - w1) * (u1 - w1), q1 = 2 * v0 * v1 - 4 * (u0 * w1 + u1 * w0), q0 = v0 * v0 - 4 * u0 * w0, beyond = std::numeric_limits<double>::infinity();
        double from = -beyond, to = beyond;
        const double root = q1 * q1 - 4 * q2 * q0, q = -0.5 * (q1 + std::copysign(std::sqrt(std::max(root, 0.0)), q1));
        if (!(root > 0) || q == 0) return LineIntervals();
        // One root is q / q2, far away where the line is almost along the parabola's axis, the other q0 / q.
        (q1 > 0 ? to : from) = q0 / q;
        if (q2 > 0) (q1 > 0 ? from : to) = q / q2;
        if (v1 != 0) (v1 > 0 ? from : to) = v1 > 0 ? std::max(from, -v0 / v1) : std::min(to, -v0 / v1);
        if (v1 == 0 && v0 < 0) return LineIntervals();
        return one(from, to);
    }
    std::optional<LineIntervals> operator()(const auto&) { return std::nullopt; }
};

// The line in the coordinates under the placement; s stays. Nothing under a flat one.
std::optional<ProfileLine> line_under(const Placement& p, const ProfileLine& line) {
    const double a = p.linear(0, 0), b = p.linear(0, 1), c = p.linear(1, 0), d = p.linear(1, 1), det = a * d - b * c;
    if (!(std::fabs(det) > 0)) return std::nullopt;
    const auto back = [&](const Vec2& v) { return Vec2(d * v.x - b * v.y, a * v.y - c * v.x) / det; };
    return ProfileLine{back(line.o - Vec2(p.offset(0), p.offset(1))), back(line.d), Vec2(a * line.up.x + c * line.up.y, b * line.up.x + d * line.up.y)};
}

}  // namespace

std::optional<Use> made_of_intervals(SolidBuilder& builder, const Use& profile, const ProfileLine& line, const std::function<std::optional<Use>(const LineIntervals&)>& made) {
    if (profile.node == kEmptyNode) return use_of(kEmptyNode);
    const auto own = line_under(profile.placement, line);
    if (!own || profile.motion != 0) return std::nullopt;
    const Node node = builder.node(profile.node);
    if (const auto* shape = std::get_if<Shape>(&node)) {
        const auto in = std::visit(IntervalsIn{*own}, *shape);
        if (!in) return std::nullopt;
        return in->empty() ? use_of(kEmptyNode) : made(*in);
    }
    const auto& combination = std::get<Combination>(node);
    std::vector<Use> parts;
    for (const Use& part : combination.operands) {
        const auto of_part = made_of_intervals(builder, part, *own, made);
        if (!of_part) return std::nullopt;
        parts.push_back(*of_part);
    }
    return parts.size() == 1 ? parts[0] : use_of(builder.combine(combination.op, std::move(parts)));
}

}  // namespace whittle
