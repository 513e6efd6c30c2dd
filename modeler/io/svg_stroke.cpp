#include "modeler/io/svg_stroke.h"

#include <algorithm>
#include <cmath>

namespace whittle {
namespace {

constexpr double kChordsOfWidth = 1.0 / 128;
constexpr int kMostChords = 256;
constexpr double kLongestMitre = 2;  // in half widths: Clipper's, which OpenSCAD leaves as it is

Vec2 left_of(Vec2 v) { return {-v.y, v.x}; }

// A piece of an arc given by its bulge, at the share t of its angle.
Vec2 on_arc(Vec2 from, const DrawnSide& side, double t) {
    const Vec2 to = side.end(), half = (to - from) / 2.0;
    const double b = side.bulge, angle = 4 * std::atan(b);
    const Vec2 centre = from + half + left_of(half) * ((1 - b * b) / (2 * b));
    const double turn = angle * t, c = std::cos(turn), s = std::sin(turn);
    const Vec2 arm = from - centre;
    return centre + Vec2{c * arm.x - s * arm.y, s * arm.x + c * arm.y};
}

Vec2 on_curve(Vec2 from, const DrawnSide& side, double t) {
    const double u = 1 - t;
    if (side.degree == 2) return u * u * from + 2 * u * t * side.p[0] + t * t * side.p[1];
    return u * u * u * from + 3 * u * u * t * side.p[0] + 3 * u * t * t * side.p[1] + t * t * t * side.p[2];
}

// Of second differences of the control points, or of the arc's chord: chords that stay within `error`.
int chords_of(Vec2 from, const DrawnSide& side, double error) {
    double bend = 0;  // the largest distance of one chord, which falls with the square of their number
    if (side.degree == 1) bend = std::fabs(side.bulge) * glm::length(side.end() - from);
    if (side.degree == 2) bend = glm::length(from - 2.0 * side.p[0] + side.p[1]) / 4;
    if (side.degree == 3) bend = 0.75 * std::max(glm::length(from - 2.0 * side.p[0] + side.p[1]), glm::length(side.p[0] - 2.0 * side.p[1] + side.p[2]));
    const double n = std::ceil(std::sqrt(bend / error));
    return n >= 1 ? static_cast<int>(std::min<double>(n, kMostChords)) : 1;
}

// Corners of the line, no two neighbours equal.
std::vector<Vec2> corners_of(const DrawnContour& line, double error) {
    std::vector<Vec2> out{line.start};
    const auto add = [&](Vec2 p) {
        if (p != out.back()) out.push_back(p);
    };
    Vec2 from = line.start;
    for (const DrawnSide& side : line.sides) {
        const bool bends = side.degree > 1 || side.bulge != 0;
        const int n = bends ? chords_of(from, side, error) : 1;
        for (int i = 1; i < n; ++i) add(side.degree == 1 ? on_arc(from, side, double(i) / n) : on_curve(from, side, double(i) / n));
        add(from = side.end());
    }
    return out;
}

DrawnFigure polygon(const PlaneMap& map, std::initializer_list<Vec2> corners) {
    OutlineBuilder builder;
    for (const Vec2& p : corners) p == *corners.begin() ? builder.move_to(map, p) : builder.line_to(map, p);
    return {builder.take()};
}

DrawnFigure disc(const PlaneMap& map, Vec2 centre, double r) {
    OutlineBuilder builder;
    add_ellipse(builder, map, centre, {r, 0}, {0, r});
    return {builder.take()};
}

// What lies outside both strips at the corner p between the unit directions u and v.
DrawnFigure corner(const PlaneMap& map, Vec2 p, Vec2 u, Vec2 v, double half, LineJoin join) {
    if (join == LineJoin::kRound) return disc(map, p, half);
    const double side = u.x * v.y - u.y * v.x > 0 ? -1 : 1;  // the corner sticks out to the right of a left turn
    const Vec2 a = side * left_of(u), b = side * left_of(v);
    const double opening = 1 + glm::dot(u, v);
    if (join == LineJoin::kMiter && opening >= 2 / (kLongestMitre * kLongestMitre)) return polygon(map, {p, p + half * a, p + half / opening * (a + b), p + half * b});
    const double reach = std::tan(std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0)) / 4);
    return polygon(map, {p, p + half * a, p + half * (a + reach * u), p + half * (b - reach * v), p + half * b});
}

}  // namespace

std::vector<DrawnFigure> stroked(const DrawnContour& line, const Pen& pen, const PlaneMap& map) {
    const double half = pen.width / 2;
    const std::vector<Vec2> points = corners_of(line, kChordsOfWidth * pen.width);
    std::vector<DrawnFigure> out;
    if (points.size() < 2) return out;
    const std::size_t last = points.size() - 2;
    Vec2 before{0};
    for (std::size_t i = 0; i <= last; ++i) {
        const Vec2 a = points[i], b = points[i + 1], along = (b - a) / glm::length(b - a), across = half * left_of(along);
        const double longer = pen.cap == LineCap::kSquare ? half : 0;
        const Vec2 from = a - (i == 0 ? longer : 0) * along, to = b + (i == last ? longer : 0) * along;
        out.push_back(polygon(map, {from - across, to - across, to + across, from + across}));
        if (i > 0 && along != before) out.push_back(corner(map, a, before, along, half, pen.join));
        before = along;
    }
    if (pen.cap == LineCap::kRound)
        for (const Vec2& end : {points.front(), points.back()}) out.push_back(disc(map, end, half));
    return out;
}

}  // namespace whittle
