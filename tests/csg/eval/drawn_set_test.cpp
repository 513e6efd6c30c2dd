// drawn_set_test.cpp — drawings of Bezier curves as 2D sets: the area is the one that Green's theorem gives.
#include <catch2/catch.hpp>

#include "csg/eval/imports.h"
#include "csg/solid/parabola.h"
#include "csg/solid/profile.h"

using namespace whittle;

namespace {

double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

// Half the integral of x dy - y dx along a Bezier curve, by Gauss's rule of four points: exact up to degree 7.
double swept(Vec2 start, const DrawnSide& side) {
    constexpr std::array<double, 2> at{0.3399810435848563, 0.8611363115940526}, weight{0.6521451548625461, 0.3478548451374538};
    const std::array<Vec2, 4> p = side.degree == 1   ? std::array<Vec2, 4>{start, glm::mix(start, side.p[0], 1.0 / 3), glm::mix(start, side.p[0], 2.0 / 3), side.p[0]}
                                  : side.degree == 2 ? std::array<Vec2, 4>{start, glm::mix(start, side.p[0], 2.0 / 3), glm::mix(side.p[1], side.p[0], 2.0 / 3), side.p[1]}
                                                     : std::array<Vec2, 4>{start, side.p[0], side.p[1], side.p[2]};
    double sum = 0;
    for (std::size_t i = 0; i < 2; ++i)
        for (const double sign : {-1.0, 1.0}) {
            const double t = (1 + sign * at[i]) / 2, s = 1 - t;
            const Vec2 x = s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
            const Vec2 d = 3 * s * s * (p[1] - p[0]) + 6 * s * t * (p[2] - p[1]) + 3 * t * t * (p[3] - p[2]);
            sum += weight[i] / 2 * cross(x, d) / 2;
        }
    return sum;
}

double area_by_green(const DrawnFigure& figure) {
    double area = 0;
    for (const auto& contour : figure.contours) {
        Vec2 at = contour.start;
        for (const auto& side : contour.sides) area += swept(at, side), at = side.end();
    }
    return std::fabs(area);
}

// Of parts that do not overlap: a segment's area is two thirds of its triangle's.
double area_of(const SolidBuilder& b, NodeId id, int& segments) {
    if (const auto* c = std::get_if<Combination>(&b.node(id))) {
        double area = 0;
        for (std::size_t i = 0; i < c->operands.size(); ++i) {
            CHECK(c->operands[i].placement.is_identity());
            area += area_of(b, c->operands[i].node, segments) * (c->op == SetOp::kDifference && i > 0 ? -1 : 1);
        }
        return area;
    }
    const Shape& shape = std::get<Shape>(b.node(id));
    if (const auto* s = std::get_if<shape::ParabolicSegment>(&shape)) {
        ++segments;
        return std::fabs(cross(s->c - s->a, s->b - s->a)) / 3;
    }
    double area = 0;
    for (const auto& ring : *std::get<shape::Polygon>(shape).contours)
        for (std::size_t i = 0; i < ring.size(); ++i) area += cross(ring[i], ring[(i + 1) % ring.size()]) / 2;
    return std::fabs(area);
}

DrawnSide curve(Vec2 c, Vec2 to) { return {2, {c, to, {}}, 0}; }
DrawnSide cubic(Vec2 c, Vec2 d, Vec2 to) { return {3, {c, d, to}, 0}; }

// The structural area, once that and what Clipper makes of its chords have been found to be the area by Green's theorem.
int checked_segments(const DrawnFigure& figure, double share) {
    SolidBuilder b;
    const Use use = drawn_set(b, Drawing{{figure}, {}}, [](double) { return 0; });
    int segments = 0;
    const double green = area_by_green(figure);
    CHECK(area_of(b, use.node, segments) == Approx(green).epsilon(share));
    double chords = 0;
    for (const auto& ring : contours_of(b.so_far(), use.node, 1e-6))
        for (std::size_t i = 0; i < ring.size(); ++i) chords += cross(ring[i], ring[(i + 1) % ring.size()]) / 2;
    CHECK(chords == Approx(green).epsilon(1e-5));
    return segments;
}

}  // namespace

TEST_CASE("quadratic curves keep their area: bulging, hollow and turning from one to the other") {
    CHECK(checked_segments({{{{0, 0}, {curve({5, -4}, {10, 0}), DrawnSide::line({10, 10}), curve({5, 4}, {0, 10}), DrawnSide::line({0, 0})}}}}, 1e-14) == 2);
    CHECK(checked_segments({{{{0, 0}, {curve({5, -5}, {10, 0}), curve({15, 5}, {20, 0}), DrawnSide::line({20, 20}), DrawnSide::line({0, 20}), DrawnSide::line({0, 0})}}}}, 1e-14) == 2);
}

TEST_CASE("curves that would reach another side are halved until they do not") {
    // A thin crescent: both curves on one side of the chord that they share.
    CHECK(checked_segments({{{{0, 0}, {curve({5, -10}, {10, 0}), curve({5, -8}, {0, 0})}}}}, 1e-13) > 2);
    // A ring of two ovals, the inner one listed the other way round.
    const auto oval = [](double r, double turn) {
        return DrawnContour{{r, 0}, {curve({r, turn * r}, {0, turn * r}), curve({-r, turn * r}, {-r, 0}), curve({-r, -turn * r}, {0, -turn * r}), curve({r, -turn * r}, {r, 0})}};
    };
    CHECK(checked_segments({{oval(10, 1), oval(9, -1)}}, 1e-13) > 8);
}

TEST_CASE("a hollow curve at a sharp corner does not eat into the side beside it") {
    CHECK(checked_segments({{{{0, 0}, {curve({10, 2.4}, {20, 0}), DrawnSide::line({0, 5}), DrawnSide::line({0, 0})}}}}, 1e-13) >= 1);
}

TEST_CASE("cubic curves are told by quadratic ones, closer than anyone sees") {
    const double k = 4 * (std::sqrt(2.0) - 1) / 3 * 10;
    const DrawnFigure circle{{{{10, 0}, {cubic({10, k}, {k, 10}, {0, 10}), cubic({-k, 10}, {-10, k}, {-10, 0}), cubic({-10, -k}, {-k, -10}, {0, -10}), cubic({k, -10}, {10, -k}, {10, 0})}}}};
    CHECK(checked_segments(circle, 1e-5) < 64);
    const auto parts = parabolas_of_cubic({Vec2(0, 0), Vec2(0, 10), Vec2(10, 10), Vec2(10, -5)}, 1e-3);
    REQUIRE(parts.size() > 2);
    CHECK(parts.front().a == Vec2(0, 0));
    CHECK(parts.back().b == Vec2(10, -5));
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) CHECK(parts[i].b == parts[i + 1].a);
}

TEST_CASE("facets, where they are asked for, are chords") {
    SolidBuilder b;
    const DrawnFigure figure{{{{0, 0}, {curve({5, -4}, {10, 0}), DrawnSide::line({5, 10}), DrawnSide::line({0, 0})}}}};
    const Use use = drawn_set(b, Drawing{{figure}, {}}, [](double) { return 24; });
    CHECK(std::get<shape::Polygon>(std::get<Shape>(b.node(use.node))).contours->front().size() == 6);
}

TEST_CASE("points, halves and distances of a parabola agree") {
    const shape::ParabolicSegment s{{0, 0}, {2, 6}, {8, 1}};
    const auto [first, second] = parabola_halves(s);
    for (const double t : {0.125, 0.3, 0.5, 0.8}) {
        const Vec2 p = parabola_point(s, t);
        CHECK(glm::length(p - (t <= 0.5 ? parabola_point(first, 2 * t) : parabola_point(second, 2 * t - 1))) < 1e-14);
        CHECK(parabola_distance(s, p) < 1e-9);
        CHECK(is_inside(s, glm::mix(p, (s.a + s.b) / 2.0, 1e-6)));
        CHECK_FALSE(is_inside(s, p + (p - (s.a + s.b) / 2.0) * 1e-6));
    }
    CHECK(parabola_error(s, parabola_chords(s, 1e-3)) <= 1e-3);
    CHECK(parabola_distance(s, {3, -4}) == Approx(5));
}
