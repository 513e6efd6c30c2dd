// test_arrange.cpp — set operations on grid meshes: what touches in faces, edges and corners, and the laws of sets.
#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <random>

#include "modeler/arrange/arrange.h"
#include "modeler/arrange/crossings.h"

using namespace whittle;

namespace {

GridMesh box(std::int64_t x, std::int64_t y, std::int64_t z) {
    GridMesh m;
    for (int i = 0; i < 8; ++i) m.points.push_back({(i & 1) != 0 ? x : 0, (i & 2) != 0 ? y : 0, (i & 4) != 0 ? z : 0});
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (FacetTag i = 0; i < 12; ++i) m.tags.push_back(i / 2);
    return m;
}

// A tetrahedron with random corners, turned outward.
GridMesh tetrahedron(std::mt19937_64& random, std::int64_t size) {
    std::uniform_int_distribution<std::int64_t> coordinate(0, size);
    while (true) {
        GridMesh m;
        for (int i = 0; i < 4; ++i) m.points.push_back({coordinate(random), coordinate(random), coordinate(random)});
        const int side = side_of(plane_through(m.points[0], m.points[1], m.points[2]), m.points[3]);
        if (side == 0) continue;
        if (side > 0) std::swap(m.points[1], m.points[2]);
        m.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
        m.tags = {0, 1, 2, 3};
        return m;
    }
}

struct Placed {
    GridMesh mesh;
    GridPoint at{};
};

ArrangedMesh combined(SetOp op, const std::vector<Placed>& parts, bool join = true, bool bury = true, std::uint64_t* buried = nullptr) {
    std::vector<Operand> operands;
    Expression expression;
    std::vector<Expression::Id> ids;
    FacetTag base = 0;
    for (const Placed& p : parts) {
        operands.push_back({&p.mesh, p.at, base, static_cast<std::uint32_t>(operands.size()), false});
        base += 100;
        ids.push_back(expression.operand());
    }
    expression.finish(expression.combine(op, ids));
    ArrangeStats stats;
    ArrangeOptions options;
    options.join = join;
    options.bury = bury;
    auto made = arrange(operands, expression, options, stats);
    if (!made) FAIL(made.error().message);
    if (buried != nullptr) *buried += stats.buried;
    return std::move(*made);
}

double volume(const ArrangedMesh& m) {
    double sum = 0;
    for (const auto& t : m.triangles) sum += glm::dot(m.points[t[0]], glm::cross(m.points[t[1]], m.points[t[2]]));
    return sum / 6;
}

bool closed(const ArrangedMesh& m) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : m.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

}  // namespace

TEST_CASE("two overlapping boxes have the volumes of sets, and no triangle too many") {
    const std::vector<Placed> two{{box(10, 10, 10)}, {box(10, 10, 10), {5, 5, 5}}};
    const ArrangedMesh both = combined(SetOp::kUnion, two), common = combined(SetOp::kIntersection, two), less = combined(SetOp::kDifference, two);
    CHECK(volume(both) == 1875);
    CHECK(volume(common) == 125);
    CHECK(volume(less) == 875);
    CHECK(common.points.size() == 8);
    CHECK(common.triangles.size() == 12);
    CHECK(less.points.size() == 14);
    CHECK(both.on_grid);
}

TEST_CASE("boxes that share a face become one without it; an edge or a corner keeps them apart, and nothing is refused") {
    const GridMesh b = box(10, 10, 10);
    const ArrangedMesh face = combined(SetOp::kUnion, {{b}, {b, {10, 0, 0}}});
    CHECK(volume(face) == 2000);
    for (const Vec3& p : face.points) CHECK((p.x != 10 || p.y == 0 || p.y == 10));
    for (const GridPoint& at : {GridPoint{10, 10, 0}, GridPoint{10, 10, 10}, GridPoint{10, 3, 0}, GridPoint{3, 4, 10}, GridPoint{10, 10, 4}}) {
        const ArrangedMesh touching = combined(SetOp::kUnion, {{b}, {b, at}});
        CHECK(volume(touching) == 2000);
        CHECK(closed(touching));
        CHECK(count_crossings(touching.points, touching.triangles) == 0);
    }
}

TEST_CASE("a corner on the inside of a face is a corner of that face too") {
    GridMesh spike = box(10, 10, 10);
    spike.points = {{0, 0, 0}, {6, -3, 8}, {6, 3, 8}, {-6, 0, 8}};
    spike.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    spike.tags = {0, 1, 2, 3};
    const ArrangedMesh touching = combined(SetOp::kUnion, {{box(20, 20, 5)}, {spike, {10, 10, 5}}});
    CHECK(closed(touching));
    CHECK(count_crossings(touching.points, touching.triangles) == 0);
    CHECK(touching.points.size() == 8 + 4);
}

TEST_CASE("a corner in the middle of a side is a corner of the edge that it lies on") {
    GridMesh roof;  // on a box of 4, over one of its edges; a corner of the roof's side is within that edge
    roof.points = {{-2, 4, 4}, {-2, 0, 4}, {-2, 2, 6}, {8, 4, 4}, {8, 0, 4}, {8, 2, 6}, {1, 4, 4}};
    roof.triangles = {{0, 1, 2}, {3, 5, 4}, {1, 0, 6}, {1, 6, 3}, {1, 3, 4}, {2, 5, 3}, {2, 3, 6}, {2, 6, 0}, {2, 1, 4}, {2, 4, 5}};
    roof.tags = {0, 1, 2, 2, 2, 3, 3, 3, 4, 4};
    const ArrangedMesh both = combined(SetOp::kUnion, {{box(4, 4, 4)}, {roof}});
    CHECK(volume(both) == Approx(64 + 40));
    CHECK(closed(both));
}

TEST_CASE("a cutter flush with its body leaves no film, a body less itself leaves nothing") {
    const GridMesh b = box(10, 10, 10);
    const ArrangedMesh tunnel = combined(SetOp::kDifference, {{b}, {box(4, 4, 10), {3, 3, 0}}});
    CHECK(volume(tunnel) == 1000 - 160);
    CHECK(tunnel.triangles.size() == 32);
    CHECK(combined(SetOp::kDifference, {{b}, {b}}).triangles.empty());
    CHECK(combined(SetOp::kIntersection, {{b}, {b, {10, 0, 0}}}).triangles.empty());
    CHECK(combined(SetOp::kUnion, {{b}, {b}}).triangles.size() == 12);
}

TEST_CASE("random tetrahedra: inclusion and exclusion to the last bits, closed, never crossing") {
    const std::uint64_t seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    for (int round = 0; round < 40; ++round) {
        // Small coordinates make coincidences; large ones make points off the grid.
        const std::int64_t size = round % 2 == 0 ? 6 : 1'000'000'000;
        std::vector<Placed> parts;
        for (int i = 0; i < 3; ++i) parts.push_back({tetrahedron(random, size)});
        const double unit = std::pow(static_cast<double>(size), 3);
        const auto of = [&](SetOp op, const std::vector<Placed>& list) {
            const ArrangedMesh m = combined(op, list);
            CHECK(closed(m));
            return volume(m) / unit;
        };
        const auto pick = [&](std::initializer_list<std::size_t> which) {
            std::vector<Placed> list;
            for (const std::size_t i : which) list.push_back(parts[i]);
            return list;
        };
        const double one = of(SetOp::kUnion, pick({0})) + of(SetOp::kUnion, pick({1})) + of(SetOp::kUnion, pick({2}));
        const double two = of(SetOp::kIntersection, pick({0, 1})) + of(SetOp::kIntersection, pick({1, 2})) + of(SetOp::kIntersection, pick({0, 2}));
        CHECK(of(SetOp::kUnion, parts) == Approx(one - two + of(SetOp::kIntersection, parts)).margin(1e-12));
        CHECK(of(SetOp::kDifference, pick({0, 1})) == Approx(of(SetOp::kUnion, pick({0})) - of(SetOp::kIntersection, pick({0, 1}))).margin(1e-12));
        const ArrangedMesh joined = combined(SetOp::kUnion, parts), cut = combined(SetOp::kUnion, parts, false);
        CHECK(joined.triangles.size() <= cut.triangles.size());
        CHECK(volume(cut) / unit == Approx(volume(joined) / unit).margin(1e-12));
    }
}

TEST_CASE("facets within other operands are left out, and the solid stays what it is") {
    const std::uint64_t seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::uint64_t all_buried = 0;
    for (int round = 0; round < 30; ++round) {
        const std::int64_t size = round % 2 == 0 ? 12 : 1'000'000'000;
        std::uniform_int_distribution<std::int64_t> place(0, size), length(1, size);
        std::vector<Placed> parts;
        for (int i = 0; i < 24; ++i) {
            const GridPoint by{place(random), place(random), place(random)};
            parts.push_back({i % 3 == 0 ? tetrahedron(random, size) : box(length(random), length(random), length(random)), by});
        }
        const double unit = std::pow(static_cast<double>(size), 3);
        for (const SetOp op : {SetOp::kUnion, SetOp::kDifference, SetOp::kIntersection}) {
            std::uint64_t buried = 0;
            const ArrangedMesh fast = combined(op, parts, true, true, &buried), slow = combined(op, parts, true, false);
            CHECK(closed(fast));
            CHECK(count_crossings(fast.points, fast.triangles) == count_crossings(slow.points, slow.triangles));
            CHECK(volume(fast) / unit == Approx(volume(slow) / unit).margin(1e-12));
            CHECK(fast.points.size() == slow.points.size());
            CHECK((op != SetOp::kIntersection || buried == 0));
            all_buried += buried;
        }
    }
    CHECK(all_buried > 0);
}

TEST_CASE("a hollow that only buried facets lead to is found, with what lies in it") {
    // Six slabs close a room of 20; every slab's end is buried in another. A block stands in the room, touching nothing.
    std::vector<Placed> parts;
    for (const std::int64_t at : {0, 30}) {
        parts.push_back({box(40, 40, 10), {0, 0, at}});
        parts.push_back({box(40, 10, 38), {0, at, 1}});
        parts.push_back({box(10, 38, 38), {at, 1, 1}});
    }
    parts.push_back({box(4, 4, 4), {18, 18, 18}});
    const ArrangedMesh room = combined(SetOp::kUnion, parts);
    CHECK(volume(room) == Approx(volume(combined(SetOp::kUnion, parts, true, false))));
    CHECK(closed(room));
    double least = 100;  // distance of any point to the middle of the block
    for (const Vec3& p : room.points) least = std::min(least, glm::length(p - Vec3(20)));
    CHECK(least == Approx(std::sqrt(12.0)));
}

TEST_CASE("a mesh that crosses itself becomes its outside") {
    GridMesh two = box(10, 10, 10);
    const GridMesh other = box(10, 10, 10);
    for (const GridPoint& p : other.points) two.points.push_back({p[0] + 5, p[1] + 5, p[2] + 5});
    for (std::size_t i = 0; i < other.triangles.size(); ++i) {
        const auto& t = other.triangles[i];
        two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
        two.tags.push_back(other.tags[i] + 6);
    }
    const Operand operand{&two, {}, 0, 0, true};
    Expression alone;
    alone.finish(alone.operand());
    ArrangeStats stats;
    const auto made = arrange({&operand, 1}, alone, {}, stats);
    REQUIRE(made);
    CHECK(volume(*made) == 1875);
    CHECK(count_crossings(made->points, made->triangles) == 0);
}

TEST_CASE("an open mesh is refused, a cancelled one is interrupted") {
    GridMesh open = box(10, 10, 10);
    open.triangles.pop_back();
    open.tags.pop_back();
    const GridMesh b = box(10, 10, 10);
    const std::vector<Operand> operands{{&open, {}, 0, 0, false}, {&b, {5, 5, 5}, 100, 1, false}};
    const auto attempt = [&](bool stop) {
        Expression both;
        const auto x = both.operand(), y = both.operand();
        both.finish(both.combine(SetOp::kUnion, {x, y}));
        ArrangeStats stats;
        return arrange(operands, both, {true, [stop] { return stop; }}, stats);
    };
    REQUIRE_FALSE(attempt(false));
    CHECK(attempt(false).error().fault == Fault::kScene);
    REQUIRE_FALSE(attempt(true));
    CHECK(attempt(true).error().fault == Fault::kInterrupted);
}

TEST_CASE("a triangle crosses another by its last bit, however far the bits of its corners reach") {
    std::mt19937_64 random(5);
    std::uniform_int_distribution<int> entry(-(1 << 20), 1 << 20);
    const auto vector = [&] { return Vec3(entry(random), entry(random), entry(random)); };
    for (int n = 0; n < 200; ++n)
        for (const int bits : {0, 20, 60, 150, 190}) {  // 30 and more of the large triangle above them
            const Vec3 u = vector(), v = vector(), up(0, 0, glm::cross(u, v).z > 0 ? 1 : -1);
            if (glm::cross(u, v).z == 0) continue;
            const double h = std::ldexp(1.0, -bits);
            for (const double side : {1.0, -1.0}) {
                const std::vector<Vec3> points{-1000.0 * u - 1000.0 * v, 1000.0 * u, 1000.0 * v, h * (u + v + up), h * (2.0 * u + v + side * up), h * (u + 2.0 * v + side * up)};
                INFO("pair " << n << ", " << bits << " bits");
                CHECK(count_crossings(points, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {3, 4, 5}}) == (side < 0 ? 1u : 0u));
            }
        }
}
