#include "csg/solid/facets.h"

#include <catch2/catch.hpp>

#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/ear_clipping.h"
#include "csg/solid/polyhedron.h"
#include "csg/solid/predicates.h"
#include "csg/solid/profile.h"

using namespace whittle;

namespace {

constexpr double kPi = 3.14159265358979323846;

// Builds one shape over an optional profile and lists its facets.
FacetList facets_of_shape(const Shape& shape) {
    SolidBuilder b;
    Use root;
    root.node = b.shape(shape);
    const Solid solid = b.finish(root);
    const auto list = facets_of(solid, solid.root().node);
    REQUIRE(list);
    return *list;
}
template <class Sweep>
FacetList facets_of_sweep(const Contours& profile, Sweep sweep) {
    SolidBuilder b;
    sweep.profile = b.shape(shape::Polygon{std::make_shared<const Contours>(profile)});
    Use root;
    root.node = b.shape(sweep);
    const Solid solid = b.finish(root);
    const auto list = facets_of(solid, solid.root().node);
    REQUIRE(list);
    return *list;
}
double ngon_area(double r, int n) { return n * r * r * std::sin(2 * kPi / n) / 2; }
// A plate with two square holes and a notch that is not convex.
const Contours kPlate{{{0, 0}, {10, 0}, {10, 6}, {5, 3}, {0, 6}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{7, 1}, {7, 2}, {8, 2}, {8, 1}}};
constexpr double kPlateArea = 45 - 2;

}  // namespace

TEST_CASE("the number of fragments follows OpenSCAD's rule") {
    CHECK(fragments(10, {0, 12, 2}) == 30);
    CHECK(fragments(1, {0, 12, 2}) == 5);
    CHECK(fragments(5, {0, 12, 2}) == 16);
    CHECK(fragments(10, {30.9, 12, 2}) == 30);
    CHECK(fragments(10, {1, 12, 2}) == 3);
    CHECK(fragments(10, {-4, 12, 2}) == 30);
    CHECK(fragments(1e-7, {100, 12, 2}) == 3);
    CHECK(fragments(10, {std::nan(""), 12, 2}) == 3);
    CHECK(fragments(1000, {0, 0, 1e9}) == 5);
    CHECK(fragments(1000, {0, 0, 0}) == 36000);
}

TEST_CASE("facets are closed and hold what their formulas say") {
    const FacetList box = facets_of_shape(shape::Box{{0, 0, 0}, {1, 2, 3}});
    CHECK(open_edges(box) == 0);
    CHECK(signed_volume(box) == Approx(6));
    for (const int n : {3, 4, 7, 30}) {
        const FacetList ball = facets_of_shape(shape::FacetedBall{5, n});
        CHECK(open_edges(ball) == 0);
        CHECK(signed_volume(ball) > 0);
        CHECK(ball.points.size() == static_cast<std::size_t>(n * ((n + 1) / 2)));
        const FacetList bar = facets_of_shape(shape::FacetedFrustum{-1, 4, 2, 2, n});
        CHECK(open_edges(bar) == 0);
        CHECK(signed_volume(bar) == Approx(5 * ngon_area(2, n)));
        for (const auto& [r0, r1] : {std::pair{2.0, 0.0}, {0.0, 2.0}}) {
            const FacetList cone = facets_of_shape(shape::FacetedFrustum{-1, 4, r0, r1, n});
            CHECK(open_edges(cone) == 0);
            CHECK(signed_volume(cone) == Approx(5 * ngon_area(2, n) / 3));
            CHECK(cone.points.size() == static_cast<std::size_t>(n + 1));
        }
    }
}

TEST_CASE("a ball of facets has no poles and starts on +x") {
    const FacetList ball = facets_of_shape(shape::FacetedBall{2, 6});
    CHECK(ball.points[0] == Vec3(2 * sind(30), 0, 2 * cosd(30)));
    CHECK(ball.points[6] == Vec3(2, 0, 0));
    CHECK(ball.facets[0].size() == 6);
}

TEST_CASE("straight extrusions of a plate with holes are closed and full") {
    for (const double top : {1.0, 0.5, 0.0}) {
        const FacetList list = facets_of_sweep(kPlate, shape::Extrusion{0, 1, 3, 0, Vec2(top), 0});
        CHECK(open_edges(list) == 0);
        CHECK(signed_volume(list) == Approx(kPlateArea * 2 * (1 + top + top * top) / 3));
    }
}

TEST_CASE("twisted and wedge-shaped extrusions are closed") {
    const FacetList twisted = facets_of_sweep(kPlate, shape::Extrusion{0, 0, 10, 120, Vec2(1), 400});
    CHECK(open_edges(twisted) == 0);
    CHECK(signed_volume(twisted) == Approx(kPlateArea * 10).epsilon(0.01));
    const Contours square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    const FacetList wedge = facets_of_sweep(square, shape::Extrusion{0, 0, 3, 0, {1, 0}, 1});
    CHECK(open_edges(wedge) == 0);
    CHECK(signed_volume(wedge) == Approx(6));
    // Clockwise going up: the corner on the diagonal comes to +x, y = 0 after 45 degrees.
    const FacetList turned = facets_of_sweep(square, shape::Extrusion{0, 0, 1, 45, Vec2(1), 1});
    const auto on_axis = [](const Vec3& p) { return p.z == 1 && std::fabs(p.y) < 1e-12 && p.x > 1.4; };
    CHECK(std::any_of(turned.points.begin(), turned.points.end(), on_axis));
}

TEST_CASE("revolutions by fragments are closed, whole or part, on the axis or beside it") {
    const Contours beside{{{2, 0}, {4, 0}, {4, 1}, {2, 1}}}, on_axis{{{0, 0}, {3, 0}, {0, 3}}};
    const int n = 12;
    const FacetList ring = facets_of_sweep(beside, shape::Revolution{0, 180, 360, n});
    CHECK(open_edges(ring) == 0);
    CHECK(signed_volume(ring) == Approx(ngon_area(4, n) - ngon_area(2, n)));
    CHECK(std::find(ring.points.begin(), ring.points.end(), Vec3(-4, 0, 0)) != ring.points.end());
    const FacetList cone = facets_of_sweep(on_axis, shape::Revolution{0, 180, 360, n});
    CHECK(open_edges(cone) == 0);
    CHECK(signed_volume(cone) == Approx(ngon_area(3, n)));
    const FacetList sector = facets_of_sweep(on_axis, shape::Revolution{0, 0, 90, 3});
    CHECK(open_edges(sector) == 0);
    CHECK(signed_volume(sector) == Approx(ngon_area(3, 12) / 4));
    CHECK(std::find(sector.points.begin(), sector.points.end(), Vec3(0, 3, 0)) != sector.points.end());
}

TEST_CASE("extrusions get as many slices as OpenSCAD gives them") {
    const Contours profile{{{-1, -1}, {3, -1}, {3, 2}, {-1, 2}}};  // counted in openscad 2021.01's OFF exports
    CHECK(extrusion_slices(profile, 10, 90, Vec2(1), {}) == 6);
    CHECK(extrusion_slices(profile, 10, -400, Vec2(1), {}) == 14);
    CHECK(extrusion_slices(profile, 10, 90, Vec2(2), {}) == 6);
    CHECK(extrusion_slices(profile, 10, 0, {2, 1}, {}) == 6);
    CHECK(extrusion_slices(profile, 10, 90, {2, 0.5}, {}) == 6);
    CHECK(extrusion_slices(profile, 10, 700, Vec2(0.1), {0, 12, 0.5}) == 53);
    CHECK(extrusion_slices(profile, 10, 100, Vec2(1), {30, 12, 0.5}) == 9);
    CHECK(extrusion_slices(profile, 10, 0, {2, 1}, {30, 12, 0.5}) == 30);
    CHECK(extrusion_slices(profile, 10, 0, Vec2(0.5), {30, 12, 0.5}) == 1);
    CHECK(extrusion_slices(profile, 10, 30, Vec2(0), {}) == 3);
}

TEST_CASE("curved shapes have no facets") {
    SolidBuilder b;
    Use root;
    root.node = b.shape(shape::Ellipsoid{Vec3(1)});
    const Solid solid = b.finish(root);
    CHECK_FALSE(facets_of(solid, solid.root().node));
}

TEST_CASE("facets that would fill the memory are refused") {
    SolidBuilder b;
    Use root;
    root.node = b.shape(shape::FacetedBall{1, 1000000});
    const Solid solid = b.finish(root);
    const auto list = facets_of(solid, solid.root().node);
    REQUIRE_FALSE(list);
    CHECK(list.error().fault == Fault::kScene);
}

TEST_CASE("ear clipping covers a region with holes once and keeps every corner") {
    std::vector<Vec2> points;
    std::vector<std::vector<std::uint32_t>> rings;
    for (const auto& contour : kPlate) {
        auto& ring = rings.emplace_back();
        for (const Vec2& p : contour) {
            ring.push_back(static_cast<std::uint32_t>(points.size()));
            points.push_back(p);
        }
    }
    const auto triangles = ear_clipped(points, rings);
    REQUIRE(triangles);
    CHECK(triangles->size() == points.size() + 2 * 2 - 2);
    double area = 0;
    for (const auto& t : *triangles) {
        CHECK(turn_of(points[t[0]], points[t[1]], points[t[2]]) == 1);
        const Vec2 u = points[t[1]] - points[t[0]], v = points[t[2]] - points[t[0]];
        area += (u.x * v.y - u.y * v.x) / 2;
    }
    CHECK(area == Approx(kPlateArea));
}

TEST_CASE("signs are exact where doubles round") {
    CHECK(turn_of({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}) == 0);
    CHECK(turn_of({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 25.0)}) == 1);
    CHECK(turn_of({0.5, 0.5}, {12, 12}, {24, std::nextafter(24.0, 23.0)}) == -1);
    CHECK(are_coplanar({0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 0.1}, {7, 3, 0.1}));
    CHECK_FALSE(are_coplanar({0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 0.1}, {7, 3, std::nextafter(0.1, 1.0)}));
    CHECK(are_collinear({0, 0, 0}, {1, 2, 3}, {2, 4, 6}));
    CHECK_FALSE(are_collinear({0, 0, 0}, {1, 2, 3}, {2, 4, std::nextafter(6.0, 7.0)}));
}

TEST_CASE("contours of set operations keep the author's corners and drop what is cut away") {
    SolidBuilder b;
    Use plate, hole;
    plate.node = b.shape(shape::Rectangle{{0, 0}, {0.3, 0.1}});
    hole.node = b.shape(shape::Disc{0.01});
    hole.placement = Placement::translation({0.05, 0.05, 0});
    Use root;
    root.node = b.combine(SetOp::kDifference, {plate, hole});
    const Solid solid = b.finish(root);
    const Contours contours = contours_of(solid, solid.root().node, 1e-5);
    REQUIRE(contours.size() == 2);
    double area = 0;
    for (const auto& c : contours)
        for (std::size_t i = 0; i < c.size(); ++i) area += (c[i].x * c[(i + 1) % c.size()].y - c[i].y * c[(i + 1) % c.size()].x) / 2;
    CHECK(area == Approx(0.03 - kPi * 1e-4).epsilon(1e-4));
    CHECK(std::find(contours[0].begin(), contours[0].end(), Vec2(0.3, 0.1)) != contours[0].end());
}

TEST_CASE("facets that are not flat are cut, flat ones stay") {
    FacetList mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1.5}, {0, 1, 1}};
    mesh.facets = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    REQUIRE(open_edges(mesh) == 0);
    const FacetList flat = with_flat_facets(mesh);
    CHECK(flat.facets.size() == 7);
    CHECK(open_edges(flat) == 0);
    CHECK_FALSE(is_flat(mesh, mesh.facets[1]));
    CHECK(is_convex(mesh, mesh.facets[0]));
}

TEST_CASE("$fe bounds the chord error, of circles and of helices") {
    CHECK(fragments(10, {0, 12, 2, 0.1}) == 23);   // pi / acos(1 - 0.01) = 22.2
    CHECK(fragments(10, {8, 12, 2, 0.1}) == 8);    // $fn goes first
    CHECK(fragments(10, {0, 12, 2, 5}) == 5);
    CHECK(fragments(0.01, {0, 12, 2, 1e-5}) == 7);  // none shorter than 0.01
    CHECK(fragments(10, {0, 12, 2, 0}) == 30);
    for (const double r : {1.0, 10.0, 300.0}) CHECK(r * (1 - std::cos(3.14159265358979323846 / fragments(r, {0, 12, 2, 0.02}))) <= 0.02);
    const Contours square{{{10, 0}, {0, 10}, {-10, 0}, {0, -10}}};
    CHECK(extrusion_slices(square, 20, 180, {1, 1}, {0, 12, 2, 0.1}) == 12);
    CHECK(extrusion_slices(square, 20, 180, {1, 1}, {0, 12, 2, 50}) == 2);
}
