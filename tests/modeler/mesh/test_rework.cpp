// test_rework.cpp — fewer triangles and even ones: valid, no farther from the surface than is said; and CGAL's booleans as another's opinion.
#include <cmath>
#include <map>
#include <set>

#include "modeler/arrange/crossings.h"
#include "modeler/mesh/deviation.h"
#include "modeler/mesh/reference_mesh.h"
#include "modeler/mesh/rework.h"
#include "solids.h"

using namespace whittle;
using namespace whittle::test;
using Catch::Matchers::WithinRel;

namespace {

Mesh flat_square(double z, int pieces) {
    Mesh mesh;
    for (int y = 0; y <= pieces; ++y)
        for (int x = 0; x <= pieces; ++x) mesh.points.emplace_back(10.0 * x / pieces, 10.0 * y / pieces, z);
    const auto n = static_cast<std::uint32_t>(pieces), row = n + 1;
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * row + x;
            mesh.triangles.push_back({a, a + 1, a + row});
            mesh.triangles.push_back({a + 1, a + row + 1, a + row});
        }
    return mesh;
}

// A cube less a ball and a bore, in two colours.
Solid carved(SolidBuilder& b) {
    const NodeId cube = b.shape(shape::Box{Vec3(-10), Vec3(10)}), ball = b.shape(shape::Ellipsoid{Vec3(12)}), bore = b.shape(shape::Frustum{-20, 20, 4, 4});
    return b.finish(at(b.combine(SetOp::kDifference, {at(b.combine(SetOp::kIntersection, {at(cube), at(ball)})), at(bore)})));
}

MeshResult mesh_of(const Solid& solid, double tolerance) {
    MeshControl control;
    MeshOptions options;
    options.tolerance_mm = tolerance;
    auto made = mesh_solid(solid, options, control);
    REQUIRE(made);
    return std::move(*made);
}

void check_valid(const MeshResult& result) {
    CHECK(result.report.valid());
    CHECK(result.report.open_edges == 0);
    CHECK(count_crossings(result.mesh.points, result.mesh.triangles) == 0);
    CHECK(result.mesh.leaf.size() == result.mesh.triangles.size());
}

using Side = std::pair<std::array<double, 3>, std::array<double, 3>>;

// Edges that run from left to right with red on one side and not on the other.
std::set<Side> rim_of(const MeshResult& r) {
    std::map<Side, int> reds;
    for (std::size_t i = 0; i < r.mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &a = r.mesh.points[r.mesh.triangles[i][k]], &b = r.mesh.points[r.mesh.triangles[i][(k + 1) % 3]];
            const std::array<double, 3> p{a.x, a.y, a.z}, q{b.x, b.y, b.z};
            reds[std::minmax(p, q)] += r.leaves[r.mesh.leaf[i]].material.color ? 1 : 0;
        }
    std::set<Side> out;
    for (const auto& [side, red] : reds)
        if (red == 1) out.insert(side);
    return out;
}

Vec3 at_share(const std::array<double, 3>& from, const std::array<double, 3>& to, double share) {
    return glm::mix(Vec3(from[0], from[1], from[2]), Vec3(to[0], to[1], to[2]), share);
}

double distance_to(const std::set<Side>& sides, const Vec3& p) {
    double least = HUGE_VAL;
    for (const auto& [from, to] : sides) {
        const Vec3 a = at_share(from, to, 0), way = at_share(from, to, 1) - a;
        least = std::min(least, glm::distance(p, a + std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0) * way));
    }
    return least;
}

}  // namespace

TEST_CASE("the distance between two surfaces is bounded for every point of them") {
    const Mesh below = flat_square(0, 1), above = flat_square(0.5, 7);
    const auto apart = hausdorff_within(below, above, 0.6);
    REQUIRE(apart);
    CHECK(*apart >= 0.5);
    CHECK(*apart <= 0.6);
    CHECK_FALSE(hausdorff_within(below, above, 0.49));
    // A dent between the corners of the others: seen from one side only.
    Mesh dented = flat_square(0, 8);
    dented.points[40].z = -2;
    CHECK(deviation_within(dented, below, 3) == Approx(2));
    CHECK_FALSE(deviation_within(dented, below, 1.9));
    const auto back = deviation_within(below, dented, 1.99);
    REQUIRE(back);
    CHECK(*back < 1.99);
    CHECK_FALSE(deviation_within(below, Mesh{}, 100));
    CHECK(deviation_within(Mesh{}, below, 1) == 0.0);
}

TEST_CASE("a simplified mesh has fewer triangles and strays no farther than was asked") {
    SolidBuilder b;
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(10)}), bite = b.shape(shape::Ellipsoid{Vec3(6)});
    const MeshResult fine = mesh_of(b.finish(at(b.combine(SetOp::kDifference, {at(ball), at(bite, {8, 1, 2})}))), 0.01);
    MeshControl control;
    std::size_t before = fine.mesh.triangles.size();
    for (const double most : {0.05, 0.5}) {
        const auto made = simplified(fine, most, control);
        REQUIRE(made);
        REQUIRE(made->changed);
        check_valid(made->result);
        CHECK(made->deviation <= most);
        CHECK(hausdorff_within(fine.mesh, made->result.mesh, most));
        CHECK(made->result.mesh.triangles.size() < before);
        CHECK(made->result.report.genus == fine.report.genus);
        before = made->result.mesh.triangles.size();
    }
    CHECK(before * 2 < fine.mesh.triangles.size());
}

TEST_CASE("walls of bores and thin walls are simplified too, and neither caves in nor goes") {
    SolidBuilder b;
    const NodeId block = b.shape(shape::Box{Vec3(-20), Vec3(20)}), bore = b.shape(shape::Frustum{-25, 25, 8, 8});
    const Solid bored = b.finish(at(b.combine(SetOp::kDifference, {at(block), at(bore)})));
    SolidBuilder c;
    const Solid tube = c.finish(at(c.combine(SetOp::kDifference, {at(c.shape(shape::Frustum{-20, 20, 16, 16})), at(c.shape(shape::Frustum{-25, 25, 15.8, 15.8}))})));
    for (const Solid* solid : {&bored, &tube}) {
        const MeshResult fine = mesh_of(*solid, 0.002);
        MeshControl control;
        const auto made = simplified(fine, 0.05, control);
        REQUIRE(made);
        REQUIRE(made->changed);
        check_valid(made->result);
        CHECK(made->deviation <= 0.05);
        CHECK(made->result.mesh.triangles.size() * 2 < fine.mesh.triangles.size());
        CHECK(made->result.report.genus == 1);
        CHECK(made->result.report.components == 1);
        CHECK_THAT(volume(made->result), WithinRel(volume(fine), 0.05 * area(fine) / volume(fine)));
    }
}

TEST_CASE("simplifying gives up corners of borders between colours, and moves none farther than was asked") {
    SolidBuilder b;
    Material red;
    red.color = Vec4(1, 0, 0, 1);
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(10)});
    const Solid solid = b.finish(at(b.combine(SetOp::kUnion, {b.labelled({red, {}, {}}, at(ball)), at(ball, {7, 3, 1})})));
    const MeshResult fine = mesh_of(solid, 0.01);
    MeshControl control;
    constexpr double kMost = 0.2;
    const auto made = simplified(fine, kMost, control);
    REQUIRE(made);
    REQUIRE(made->changed);
    CHECK(made->result.mesh.triangles.size() * 4 < fine.mesh.triangles.size());
    const auto rim = rim_of(made->result), was = rim_of(fine);
    CHECK(rim.size() >= 8);
    CHECK(rim.size() * 2 < was.size());
    for (const auto& [from, to] : was)
        for (const double share : {0.0, 0.5}) CHECK(distance_to(rim, at_share(from, to, share)) <= kMost);
    for (const auto& [from, to] : rim)
        for (const double share : {0.0, 0.25, 0.5, 0.75}) CHECK(distance_to(was, at_share(from, to, share)) <= kMost);
}

TEST_CASE("where three colours meet the corner stays") {
    SolidBuilder b;
    const auto coloured = [&](float r, float g, const Vec3& where) {
        Material m;
        m.color = Vec4(r, g, 0, 1);
        return b.labelled({m, {}, {}}, at(b.shape(shape::Ellipsoid{Vec3(10)}), where));
    };
    const Solid solid = b.finish(at(b.combine(SetOp::kUnion, {coloured(1, 0, {0, 0, 0}), coloured(0, 1, {8, 0, 0}), coloured(1, 1, {4, 7, 0})})));
    const MeshResult fine = mesh_of(solid, 0.01);
    const auto meetings = [](const MeshResult& r) {
        std::map<std::array<double, 3>, std::set<std::uint32_t>> leaves;
        for (std::size_t i = 0; i < r.mesh.triangles.size(); ++i)
            for (const std::uint32_t p : r.mesh.triangles[i]) leaves[{r.mesh.points[p].x, r.mesh.points[p].y, r.mesh.points[p].z}].insert(r.mesh.leaf[i]);
        std::set<std::array<double, 3>> out;
        for (const auto& [p, l] : leaves)
            if (l.size() > 2) out.insert(p);
        return out;
    };
    MeshControl control;
    const auto made = simplified(fine, 0.2, control);
    REQUIRE(made);
    REQUIRE(made->changed);
    check_valid(made->result);
    CHECK(meetings(fine).size() == 2);
    CHECK(meetings(made->result) == meetings(fine));
}

TEST_CASE("a remeshed solid has even triangles, its sharp edges, and its volume") {
    SolidBuilder b;
    const MeshResult fine = mesh_of(carved(b), 0.01);
    MeshControl control;
    const auto made = remeshed(fine, 1.0, control);
    REQUIRE(made);
    check_valid(made->result);
    CHECK(made->result.report.genus == fine.report.genus);
    CHECK_THAT(volume(made->result), WithinRel(volume(fine), 5e-3));
    CHECK(made->deviation < 0.25);
    double longest = 0;
    for (const Triangle& t : made->result.mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, glm::distance(made->result.mesh.points[t[k]], made->result.mesh.points[t[(k + 1) % 3]]));
    CHECK(longest < 2.0);
    // The flat faces stay flat: their points are where they were.
    const Bounds box = mesh_bounds(made->result.mesh), was = mesh_bounds(fine.mesh);
    for (int i = 0; i < 3; ++i) CHECK(box.hi[i] == Approx(was.hi[i]).epsilon(1e-9));
    CHECK_FALSE(remeshed(fine, 1e-4, control));
}

TEST_CASE("a bar that goes on in a ring of its own radius is remeshed, slivers between their chords and all") {
    SolidBuilder b;
    const NodeId disc = b.shape(shape::Disc{5});
    const NodeId half = b.shape(shape::Revolution{b.combine(SetOp::kUnion, {at(disc, {18, 0, 0})}), 0, 180, 0});
    const NodeId bar = b.shape(shape::Frustum{0, 20, 5, 5});
    Use along = at(bar);
    along.placement = Placement{{1, 0, 0, 18, 0, 0, 1, -20, 0, -1, 0, 0}};
    const MeshResult fine = mesh_of(b.finish(at(b.combine(SetOp::kUnion, {at(half), along}))), 0.01);
    MeshControl control;
    const auto made = remeshed(fine, 1.5, control);
    REQUIRE(made);
    check_valid(made->result);
    CHECK(made->deviation <= 0.375);
    CHECK_THAT(volume(made->result), WithinRel(volume(fine), made->deviation * area(fine) / volume(fine)));
}

TEST_CASE("a remeshed solid keeps long sharp edges and borders of colours where they were") {
    SolidBuilder b;
    Material red;
    red.color = Vec4(1, 0, 0, 1);
    const NodeId box = b.shape(shape::Box{Vec3(0), {20, 6, 4}});
    // Three boxes in a row, flush: the first red, the others of no colour and so without a border.
    const Solid solid = b.finish(at(b.combine(SetOp::kUnion, {b.labelled({red, {}, {}}, at(box)), at(box, {20, 0, 0}), at(box, {40, 0, 0})})));
    const MeshResult coarse = mesh_of(solid, 0.01);
    MeshControl control;
    const auto made = remeshed(coarse, 1.5, control);
    REQUIRE(made);
    check_valid(made->result);
    CHECK(made->deviation <= 1.5 * 0x1p-10);
    CHECK_THAT(volume(made->result), WithinRel(60.0 * 6 * 4, 1e-9));
    double red_area = 0, border = 0;
    bool in_plane = true;
    for (std::size_t i = 0; i < made->result.mesh.triangles.size(); ++i) {
        const Triangle& t = made->result.mesh.triangles[i];
        const auto p = [&](std::size_t k) { return made->result.mesh.points[t[k % 3]]; };
        for (std::size_t k = 0; k < 3; ++k) CHECK(glm::distance(p(k), p(k + 1)) < 2.5);
        if (made->result.leaves[made->result.mesh.leaf[i]].material.color) red_area += glm::length(glm::cross(p(1) - p(0), p(2) - p(0))) / 2;
    }
    CHECK_THAT(red_area, WithinRel(2.0 * 20 * (6 + 4) + 6 * 4, 1e-9));
    for (const auto& [from, to] : rim_of(made->result)) {
        in_plane = in_plane && std::fabs(from[0] - 20) < 1e-9 && std::fabs(to[0] - 20) < 1e-9;
        border += std::hypot(to[1] - from[1], to[2] - from[2]);
    }
    CHECK(in_plane);
    CHECK_THAT(border, WithinRel(2.0 * (6 + 4), 1e-9));
}

TEST_CASE("CGAL's booleans give the same solid, also where solids touch along an edge") {
    SolidBuilder b;
    const Solid solid = carved(b);
    MeshControl control;
    MeshOptions options;
    options.tolerance_mm = 0.05;
    const auto ours = mesh_solid(solid, options, control), theirs = mesh_solid_by(BooleanMaker::kCgal, solid, options, control);
    REQUIRE(ours);
    REQUIRE(theirs);
    check_valid(*theirs);
    CHECK(theirs->stats.loaded_cgal);
    CHECK_FALSE(ours->stats.loaded_cgal);
    CHECK_THAT(volume(*theirs), WithinRel(volume(*ours), 1e-9));
    CHECK_THAT(area(*theirs), WithinRel(area(*ours), 1e-9));
    CHECK(theirs->report.genus == ours->report.genus);
    // Every triangle lies on the leaf that both say it does.
    const auto area_of_leaf = [](const MeshResult& r) {
        std::vector<double> sums(r.leaves.size(), 0);
        for (std::size_t i = 0; i < r.mesh.triangles.size(); ++i) {
            const Triangle& t = r.mesh.triangles[i];
            sums[r.mesh.leaf[i]] += glm::length(glm::cross(r.mesh.points[t[1]] - r.mesh.points[t[0]], r.mesh.points[t[2]] - r.mesh.points[t[0]])) / 2;
        }
        return sums;
    };
    const auto a = area_of_leaf(*ours), c = area_of_leaf(*theirs);
    REQUIRE(a.size() == c.size());
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == Approx(c[i]).epsilon(1e-6));

    SolidBuilder d;
    const NodeId cube = d.shape(shape::Box{Vec3(0), Vec3(1)});
    const Solid edge = d.finish(at(d.combine(SetOp::kUnion, {at(cube), at(cube, {1, 1, 0})})));
    const auto one = mesh_solid(edge, options, control), other = mesh_solid_by(BooleanMaker::kCgal, edge, options, control);
    REQUIRE(one);
    REQUIRE(other);
    check_valid(*other);
    CHECK(volume(*other) == Approx(2).epsilon(1e-12));
    CHECK(area(*other) == Approx(area(*one)).epsilon(1e-12));
    CHECK(std::set<std::uint32_t>(other->mesh.leaf.begin(), other->mesh.leaf.end()).size() == 2);
}
