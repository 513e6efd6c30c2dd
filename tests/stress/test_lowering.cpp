// test_lowering.cpp — the engine's formula is the solid: against the solid's own reference, outside the mask of rays that rounding in reading decides.
#include <catch2/catch.hpp>

#include "tests/reference/shapes.h"
#include "tests/stress/compare.h"
#include "tests/stress/lowered.h"
#include "tests/support/reduce.h"
#include "tests/support/seed.h"
#include "tests/support/use.h"
#include "tracer/engine/lower.h"

using namespace whittle;
using namespace whittle::stress;
using namespace whittle::support;

namespace {

// The engine takes a scaled extrusion as facets, which only nearly are it.
bool has_scaled_extrusion(const Solid& solid) {
    for (NodeId id = 0; id < solid.node_count(); ++id)
        if (const auto* shape = std::get_if<Shape>(&solid.node(id)))
            if (const auto* e = std::get_if<shape::Extrusion>(shape); e && e->scale_top != Vec2(1)) return true;
    return false;
}

// Does something in its formula stand for a curved surface, within a tolerance?
bool has_stand_ins(const Solid& solid) {
    const Result<Formula> formula = lower(solid);
    return formula && (std::any_of(formula->nodes.begin(), formula->nodes.end(), [](const FormulaNode& n) { return !n.exact; }) ||
                       std::any_of(formula->meshes.begin(), formula->meshes.end(), [](const MeshData& m) { return !m.exact; }));
}

std::string lowering_fault(const Solid& solid, const Ray& ray, double size) {
    auto formula = lowered(solid, false);
    if (!formula) return formula.error().message;
    std::mt19937_64 random(1);
    Tally tally;
    return loose_disagreement(reference::Evaluator(solid), reference::Evaluator(std::move(formula->tree)), ray, size, random, tally);
}

void check_theme(Theme theme, int solids, int rays, std::mt19937_64& random, Tally& tally) {
    for (int i = 0; i < solids; ++i) {
        const std::uint64_t seed = random();
        const RandomSolid solid = random_solid(theme, seed);
        if (has_scaled_extrusion(solid.solid) || has_stand_ins(solid.solid)) continue;
        auto formula = lowered(solid.solid, false);
        REQUIRE(formula);
        const reference::Evaluator a(solid.solid), b(std::move(formula->tree));
        for (int k = 0; k < rays; ++k) {
            const Ray ray = random_ray(solid, random);
            INFO(name_of(theme) << " solid " << seed << "u ray " << to_text(ray));
            const std::string why = loose_disagreement(a, b, ray, solid.size, random, tally);
            if (why.empty()) continue;
            const Solid small = reduced(solid.solid, [&](const Solid& s) { return !lowering_fault(s, ray, solid.size).empty(); });
            FAIL(lowering_fault(small, ray, solid.size) << "\n  " << to_code(small));
        }
    }
}

}  // namespace

TEST_CASE("lowering keeps the solid") {
    const std::uint64_t seed = fresh_seed();
    WARN("WHITTLE_SEED=" << seed);
    std::mt19937_64 random(seed);
    Tally tally;
    for (int theme = 0; theme < kThemes; ++theme) check_theme(static_cast<Theme>(theme), 40, 8, random, tally);
    INFO(tally.pairs << " pairs, " << tally.borders << " borders, " << tally.masked << " masked");
    CHECK(tally.borders > tally.pairs / 4);
    CHECK(tally.masked * 10 < tally.pairs);
}

TEST_CASE("a section in a face of its solid is what is just above it, also to the reference") {
    const auto outlined = [](std::vector<Vec2> contour, NodeId section = kEmptyNode) {
        shape::Polygon p;
        p.contours = std::make_shared<std::vector<std::vector<Vec2>>>(1, std::move(contour));
        p.section = section;
        p.deviation = section == kEmptyNode ? 0 : 0x1p-40;
        return p;
    };
    SolidBuilder b;
    const NodeId wedge = b.shape(shape::Revolution{b.shape(outlined({{0, 0}, {2, 0}, {2, 1.5}, {0, 3}})), 90, 45, 0});
    const NodeId standing = b.combine(SetOp::kUnion, {use(wedge, Placement{{0, 1, 0, 0, 0, 0, -1, 0, -1, 0, 0, 0}})});
    const NodeId plate = b.shape(shape::Extrusion{b.shape(outlined({{0, 0}, {0, -3}, {2, -1.5}, {2, 0}}, standing)), 0, 1.75, 0, {1, 1}, 0});
    const Solid solid = b.finish(use(plate));
    Ray ray;
    ray.origin = {2, -2.25, 1.75};
    ray.direction = {-1.9, 3, -2.6};
    CHECK(lowering_fault(solid, ray, 3) == "");
    CHECK(reference::Evaluator(solid).borders(ray).borders.size() == 2);
}
