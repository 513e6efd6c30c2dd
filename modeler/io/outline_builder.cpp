#include "modeler/io/outline_builder.h"

#include <algorithm>
#include <cmath>

namespace whittle {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kPiecesOfTurn = 32;
// What four roundings on the terms of a scalar product may leave, against the terms.
constexpr double kRounding = 0x1p-48;

bool equal_and_upright(Vec2 u, Vec2 v) {
    const double uu = glm::dot(u, u), vv = glm::dot(v, v);
    return std::fabs(uu - vv) <= kRounding * (uu + vv) && std::fabs(glm::dot(u, v)) <= kRounding * (uu + vv);
}

}  // namespace

bool PlaneMap::is_similarity() const { return equal_and_upright({a, b}, {c, d}); }

PlaneMap operator*(const PlaneMap& outer, const PlaneMap& inner) {
    const Vec2 x = outer.direction({inner.a, inner.b}), y = outer.direction({inner.c, inner.d}), o = outer.point({inner.e, inner.f});
    return {x.x, x.y, y.x, y.y, o.x, o.y};
}

void OutlineBuilder::move_to(const PlaneMap& map, Vec2 p) {
    end();
    contours_.push_back({map.point(p), {}});
    open_ = true;
}

void OutlineBuilder::line_to(const PlaneMap& map, Vec2 p) { contours_.back().sides.push_back(DrawnSide::line(map.point(p))); }

void OutlineBuilder::quadratic_to(const PlaneMap& map, Vec2 a, Vec2 p) { contours_.back().sides.push_back({2, {map.point(a), map.point(p), {}}, 0}); }

void OutlineBuilder::cubic_to(const PlaneMap& map, Vec2 a, Vec2 b, Vec2 p) { contours_.back().sides.push_back({3, {map.point(a), map.point(b), map.point(p)}, 0}); }

void OutlineBuilder::arc(const PlaneMap& map, Vec2 centre, Vec2 u, Vec2 v, double from, double sweep, Vec2 to) {
    const Vec2 c = map.point(centre), mu = map.direction(u), mv = map.direction(v);
    const auto at = [&](double t) { return c + mu * std::cos(t) + mv * std::sin(t); };
    auto& sides = contours_.back().sides;
    if (equal_and_upright(mu, mv)) {
        // At most half a turn a side; the sign of the turn is that of the map.
        const int n = std::max(1, static_cast<int>(std::ceil(std::fabs(sweep) / kPi - kRounding)));
        const double sign = mu.x * mv.y - mu.y * mv.x < 0 ? -1 : 1;
        for (int i = 1; i <= n; ++i) sides.push_back(DrawnSide::arc(i == n ? map.point(to) : at(from + sweep * i / n), sign * std::tan(sweep / n / 4)));
        return;
    }
    const int n = std::max(1, static_cast<int>(std::ceil(std::fabs(sweep) / (2 * kPi) * kPiecesOfTurn)));
    const double step = sweep / n, reach = 4.0 / 3 * std::tan(step / 4);
    const auto along = [&](double t) { return mv * std::cos(t) - mu * std::sin(t); };
    for (int i = 1; i <= n; ++i) {
        const double t0 = from + step * (i - 1), t1 = from + step * i;
        const Vec2 end = i == n ? map.point(to) : at(t1);
        sides.push_back({3, {at(t0) + along(t0) * reach, end - along(t1) * reach, end}, 0});
    }
}

void OutlineBuilder::close() {
    if (!open_) return;
    DrawnContour& contour = contours_.back();
    if (!contour.sides.empty() && contour.sides.back().end() != contour.start) contour.sides.push_back(DrawnSide::line(contour.start));
    end();
}

// Contours without sides are dropped; what is open yet was left so.
void OutlineBuilder::end() {
    if (!open_) return;
    open_ = false;
    DrawnContour& contour = contours_.back();
    if (contour.sides.empty()) return contours_.pop_back();
    left_open_.push_back(contour.sides.back().end() != contour.start);
    if (left_open_.back()) contour.sides.push_back(DrawnSide::line(contour.start));
}

std::vector<bool> OutlineBuilder::left_open() const {
    std::vector<bool> out = left_open_;
    if (open_ && !contours_.back().sides.empty()) out.push_back(contours_.back().sides.back().end() != contours_.back().start);
    return out;
}

std::vector<DrawnContour> OutlineBuilder::take() {
    end();
    left_open_.clear();
    return std::exchange(contours_, {});
}

void add_ellipse(OutlineBuilder& builder, const PlaneMap& map, Vec2 centre, Vec2 u, Vec2 v) {
    builder.move_to(map, centre + u);
    builder.arc(map, centre, u, v, 0, kPi, centre - u);
    builder.arc(map, centre, u, v, kPi, kPi, centre + u);
    builder.close();
}

}  // namespace whittle
