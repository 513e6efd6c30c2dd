// test_agreement.cpp — right meshes agree; meshes with a planted fault do not. Place and size of a fault come from a printed seed.
#include <iterator>
#include <random>

#include "csg/solid/facets.h"
#include "modeler/check/agreement.h"
#include "tests/modeler/check/check_solids.h"
#include "tests/modeler/check/faults.h"
#include "tests/modeler/check/true_outlines.h"
#include "tests/support/random_solid.h"
#include "tests/support/seed.h"

using namespace whittle;
using namespace whittle::test;

namespace {

MeshResult meshed(const Solid& solid) {
    MeshControl control;
    auto result = mesh_solid(solid, {}, control);
    REQUIRE(result);
    return *result;
}

Agreement agreement(const Solid& solid, const MeshResult& made, const Mesh& mesh, std::uint64_t lines = 4096) {
    AgreementOptions options;
    options.tolerance = made.tolerance_mm;
    options.rounding = made.grid_mm;
    options.lines = lines;
    const auto a = check_agreement(solid, *compiled(solid), mesh, options);
    REQUIRE(a);
    return *a;
}

Solid box_and_ball() {
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{Vec3(-4), Vec3(4)});
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(3)});
    const NodeId rod = b.shape(shape::Frustum{-9, 9, 1, 1});
    const NodeId hollow = b.combine(SetOp::kDifference, {use(box), use(rod, tilted(90))});
    return b.finish(use(b.combine(SetOp::kUnion, {use(hollow), use(ball, Placement::translation({0, 0, 5}))})));
}

}  // namespace

TEST_CASE("exact solids and their meshes agree, and their volumes do") {
    for (const Solid& solid : {one_shape(shape::Box{Vec3(-1), Vec3(2)}, tilted(17)), one_shape(shape::Ellipsoid{Vec3(3)}), one_shape(shape::Torus{5, 2}),
                               tricylinder(2), carved_cube(), box_and_ball(), sponge(2)}) {
        const MeshResult made = meshed(solid);
        const Agreement a = agreement(solid, made, made.mesh);
        CAPTURE(a.worst.distance, a.worst.bound, a.disagreements_in_all, a.volume_spans.value, a.volume_mesh.value, a.tolerance);
        CHECK(a.agree);
        CHECK(a.lines == 4096);
        CHECK(a.difference_volume.value - a.difference_volume.error <= a.difference_bound);
    }
}

TEST_CASE("a twisted profile of abutting polygons is whole, to rays and as a mesh") {
    SolidBuilder b;
    const auto polygon = [&](std::vector<Vec2> ring) { return use(b.shape(shape::Polygon{std::make_shared<const Contours>(Contours{std::move(ring)})})); };
    const NodeId profile = b.combine(SetOp::kUnion, {polygon({{4, 0}, {6, 0}, {6.5, 1}, {3.7, 1.1}}), polygon({{3.7, 1.1}, {6.5, 1}, {6, 2.1}, {4, 2}}),
                                                     polygon({{4.5, 2.025}, {5.5, 2.075}, {5, 3}})});
    const Solid solid = b.finish(use(b.shape(shape::Extrusion{profile, 0, 10, 400, Vec2(1), 20})));
    const MeshResult made = meshed(solid);
    CHECK(made.report.components == 1);
    const Agreement a = agreement(solid, made, made.mesh);
    CHECK(a.agree);
    // Nothing gapes between the polygons: the area is the mesh's.
    CHECK(a.area_spans.value == Approx(a.area_mesh.value).margin(4 * a.area_spans.error));
}

TEST_CASE("arcs drawn beside chords of other arcs leave no films") {
    SolidBuilder b;
    const NodeId disc = b.shape(shape::Disc{10}), wide = b.shape(shape::Rectangle{{-20, 3}, {20, 20}});
    const NodeId cap = b.combine(SetOp::kIntersection, {use(disc), use(wide)});
    const double x = std::sqrt(91.0);
    const NodeId body = b.shape(shape::Polygon{std::make_shared<const Contours>(Contours{{{-x, 3}, {-7, -6}, {7, -6}, {x, 3}}})});
    const NodeId profile = b.combine(SetOp::kUnion, {use(body), use(cap), use(body, Placement::translation({0.1, 0, 0}))});
    const Solid solid = b.finish(use(b.shape(shape::Extrusion{profile, 0, 5, 0, Vec2(1), 0}), tilted(25)));
    const MeshResult made = meshed(solid);
    CHECK(made.report.components == 1);
    CHECK(made.report.genus == 0);
    CHECK(agreement(solid, made, made.mesh).agree);
}

TEST_CASE("flat solids are allowed rounding alone") {
    const Solid solid = sponge(2);
    const MeshResult made = meshed(solid);
    const Agreement a = agreement(solid, made, made.mesh);
    CHECK(a.tolerance == 0);
    CHECK(a.rounding < 1e-9);
    CHECK(a.difference_volume.value < 1e-9);
    Mesh moved = made.mesh;
    for (Vec3& p : moved.points) p.x += 1e-7;
    CHECK_FALSE(agreement(solid, made, moved).agree);
}

namespace {

// How many of the seeds go undetected, per kind.
std::uint64_t undetected(const NamedFault& fault, const Subject& subject, const Program& program, std::uint64_t seeds) {
    std::uint64_t missed = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        std::mt19937_64 random(seed);
        AgreementOptions options;
        options.tolerance = subject.made.tolerance_mm;
        options.rounding = subject.made.grid_mm;
        options.lines = 4096;
        options.seed = seed;
        const auto a = check_agreement(subject.solid, program, fault.plant(subject, 3 * subject.made.tolerance_mm, random), options);
        REQUIRE(a);
        if (a->agree) UNSCOPED_INFO(fault.name << " of seed " << seed << " was not seen");
        missed += a->agree ? 1U : 0U;
    }
    return missed;
}

}  // namespace

TEST_CASE("every kind of planted fault is found") {
    const Subject s = subject(0.02);
    const auto program = compiled(s.solid);
    CHECK(faults().size() >= 20);
    for (const NamedFault& fault : faults()) CHECK(undetected(fault, s, *program, 1) == 0);
}

TEST_CASE("of a hundred seeds of every fault 99 are found", "[.][soak]") {
    const Subject s = subject(0.02);
    const auto program = compiled(s.solid);
    for (const NamedFault& fault : faults()) {
        const std::uint64_t missed = undetected(fault, s, *program, 100);
        WARN(fault.name << ": " << 100 - missed << " of 100");
        CHECK(missed <= 1);
    }
}

namespace {

// Random trees whose meshes agree, of `count`; the others are named.
std::uint64_t agreeing_trees(std::uint64_t count, std::uint64_t first = 0) {
    std::uint64_t good = 0;
    constexpr support::Theme kThemes[] = {support::Theme::kPlanes, support::Theme::kRound, support::Theme::kEverything, support::Theme::kStack,
                                          support::Theme::kInstances, support::Theme::kChain};
    for (std::uint64_t i = first; i < first + count; ++i) {
        const support::Theme theme = kThemes[i % std::size(kThemes)];
        const Solid tree = with_true_outlines(support::random_solid(theme, 1 + i / std::size(kThemes)).solid);
        MeshControl control;
        const auto made = mesh_solid(tree, {}, control);
        const auto program = compile(tree);
        if (!made || !program) {
            WARN(support::name_of(theme) << " " << 1 + i / std::size(kThemes) << ": " << (made ? program.error().message : made.error().message));
            continue;
        }
        AgreementOptions options;
        options.tolerance = made->tolerance_mm;
        options.rounding = made->grid_mm;
        options.lines = 2048;
        const auto a = check_agreement(tree, **program, made->mesh, options);
        if (a && a->agree) {
            ++good;
            continue;
        }
        const Disagreement d = a && !a->disagreements.empty() ? a->disagreements.front() : Disagreement{};
        WARN(support::name_of(theme) << " " << 1 + i / std::size(kThemes) << ": " << (a ? name_of(d.kind) : a.error().message.c_str()) << " off by " << d.distance << " of "
                                     << d.bound << ", " << (a ? a->disagreements_in_all : 0) << " in all");
    }
    return good;
}

}  // namespace

TEST_CASE("meshes of random trees agree with their spans") { CHECK(agreeing_trees(12) == 12); }

TEST_CASE("a turned parabola, cones through chords to rays, agrees with its mesh") {
    SolidBuilder b;
    const Solid solid = b.finish(use(b.shape(shape::Revolution{b.shape(shape::ParabolicSegment{{0, 0}, {1.75, 3.5}, {3.5, 0}}), 30, 360, 0})));
    const MeshResult made = meshed(solid);
    CHECK(agreement(solid, made, made.mesh).agree);
}

TEST_CASE("a mesh finer than the chords that rays meet agrees, and the chords are said") {
    SolidBuilder b;
    const Solid solid = b.finish(use(b.shape(shape::Revolution{b.shape(shape::ParabolicSegment{{0, 0}, {1.75, 3.5}, {3.5, 0}}), 30, 360, 0})));
    MeshControl control;
    MeshOptions fine;
    fine.tolerance_mm = 1e-4;
    const auto made = mesh_solid(solid, fine, control);
    REQUIRE(made);
    const Agreement a = agreement(solid, *made, made->mesh);
    CHECK(a.agree);
    CHECK(a.own_deviation > 0);
    CHECK(a.own_deviation < 4e-3);
    CHECK(a.worst.distance > fine.tolerance_mm);  // without them it would not
    const Solid round = box_and_ball();
    CHECK(agreement(round, meshed(round), meshed(round).mesh).own_deviation == 0);
}

// In tens, so that a run that is stopped has said how far it came; WHITTLE_FROM is the first tree.
TEST_CASE("meshes of 300 random trees agree with their spans", "[.][soak]") {
    for (std::uint64_t first = support::first_of_run(); first < 300; first += 10) {
        CHECK(agreeing_trees(10, first) == 10);
        WARN("asked up to " << first + 10);
    }
}

TEST_CASE("a disagreement names the line that shows it and the source line nearest to it") {
    SolidBuilder b;
    Label label;
    label.place = {0, 42, 1};
    Use box = use(b.shape(shape::Box{Vec3(0), Vec3(2)}));
    box.label = b.label(label);
    const Solid solid = b.finish(box);
    const MeshResult made = meshed(solid);
    Mesh larger = made.mesh;
    for (Vec3& p : larger.points) p *= 1.25;
    const Agreement a = agreement(solid, made, larger);
    REQUIRE_FALSE(a.agree);
    REQUIRE(!a.disagreements.empty());
    const Disagreement& d = a.disagreements.front();
    CHECK(d.place.line == 42);
    CHECK(d.in_mesh);
    CHECK(d.distance > d.bound);
    CHECK(d.distance <= 0.5 * std::sqrt(3) + 1e-9);
}

TEST_CASE("an agreement's bytes do not depend on the run") {
    const Solid solid = carved_cube();
    const MeshResult made = meshed(solid);
    const Agreement a = agreement(solid, made, made.mesh), b = agreement(solid, made, made.mesh);
    CHECK(a.difference_volume.value == b.difference_volume.value);
    CHECK(a.worst.distance == b.worst.distance);
    CHECK(a.worst.ray.origin == b.worst.ray.origin);
}
