// test_measure.cpp — measured values against closed forms, and the intervals against the truth.
#include <cmath>

#include <tbb/global_control.h>

#include "tests/modeler/check/check_solids.h"

using namespace whittle;
using namespace whittle::test;

namespace {

void holds(const Measured& m, double truth) {
    CAPTURE(m.value, m.error, truth);
    CHECK(std::fabs(m.value - truth) <= m.error);
}

}  // namespace

TEST_CASE("a ball's volume, area, centroid and inertia are those of the formulas") {
    const Measurement m = measured(one_shape(shape::Ellipsoid{Vec3(3)}, Placement::translation({1, -2, 5})));
    CHECK(m.method == "lines");
    const double v = 36 * M_PI;
    holds(m.volume, v);
    CHECK(m.volume.error < 1e-4 * v);
    CHECK(m.volume.kind == ErrorKind::kConfidence99);
    holds(m.area, 36 * M_PI);
    holds(m.centroid[0], 1);
    holds(m.centroid[1], -2);
    holds(m.centroid[2], 5);
    for (std::size_t i = 0; i < 3; ++i) holds(m.inertia[4 * i], 0.4 * v * 9);
    holds(m.inertia[1], 0);
    holds(m.lo[0], -2);
    holds(m.hi[2], 8);
    CHECK(m.hi[2].error < 1e-9);
}

TEST_CASE("a torus has Pappus' volume and area") {
    const Measurement m = measured(one_shape(shape::Torus{5, 2}, tilted(33)));
    holds(m.volume, 2 * M_PI * M_PI * 5 * 4);
    holds(m.area, 4 * M_PI * M_PI * 5 * 2);
    CHECK(m.volume.error < 1e-4 * m.volume.value);
}

TEST_CASE("three crossing cylinders share 8 (2 - sqrt 2) r^3") {
    const Measurement m = measured(tricylinder(2));
    holds(m.volume, 8 * (2 - std::sqrt(2)) * 8);
    holds(m.area, 24 * (2 - std::sqrt(2)) * 4);
    CHECK(m.volume.error < 1e-4 * m.volume.value);
}

TEST_CASE("a box whose faces lie in axis planes is measured exactly") {
    const Measurement m = measured(one_shape(shape::Box{{-1, 0, 2}, {4, 3, 9}}));
    CHECK(m.method == "planes");
    CHECK(m.volume.kind == ErrorKind::kBound);
    CHECK(m.volume.value == 105);
    CHECK(m.volume.error < 1e-9);
    CHECK(m.area.value == 2 * (15 + 21 + 35));
    CHECK(m.centroid[1].value == Approx(1.5).epsilon(1e-14));
    CHECK(m.inertia[0].value == Approx(105 / 12.0 * (9 + 49)).epsilon(1e-13));
    CHECK(m.inertia[8].value == Approx(105 / 12.0 * (25 + 9)).epsilon(1e-13));
    CHECK(m.lo[2].value == 2);
    CHECK(m.hi[0].value == 4);
}

TEST_CASE("Menger's sponge is measured exactly by its planes") {
    for (const int level : {1, 2, 3}) {
        const Measurement m = measured(sponge(level));
        CHECK(m.method == "planes");
        CHECK(m.volume.value == std::pow(20, level));
        const double face = std::pow(9, level);
        CHECK(m.area.value == Approx(face * (2 * std::pow(20.0 / 9, level) + 4 * std::pow(8.0 / 9, level))).epsilon(1e-12));
    }
}

TEST_CASE("lines and planes agree on a sponge, and on a tilted one") {
    MeasureOptions options;
    options.allow_exact = false;
    holds(measured(sponge(2), options).volume, 400);
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{Vec3(0), Vec3(2, 3, 4)});
    const Measurement tilt = measured(b.finish(use(box, tilted(20))));
    CHECK(tilt.method == "lines");
    holds(tilt.volume, 24);
    holds(tilt.area, 52);
}

TEST_CASE("a solid less itself measures nothing") {
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{Vec3(0), Vec3(2)});
    const NodeId ball = b.shape(shape::Ellipsoid{Vec3(2)});
    const Measurement none = measured(b.finish(use(b.combine(SetOp::kDifference, {use(box), use(box)}))));
    CHECK(none.volume.value == 0);
    CHECK(none.lo[0].value > none.hi[0].value);
    SolidBuilder c;
    const NodeId other = c.shape(shape::Ellipsoid{Vec3(2)});
    CHECK(measured(c.finish(use(c.combine(SetOp::kDifference, {use(other), use(other)})))).volume.value == 0);
    CHECK(ball != kEmptyNode);
}

TEST_CASE("an unbounded solid has no volume") {
    const Solid solid = one_shape(shape::HalfSpace{{0, 0, 1}, 3});
    const auto program = compile(solid);
    if (program) {
        const auto m = measure(solid, **program);
        REQUIRE(!m);
        CHECK(m.error().fault == Fault::kScene);
    } else {
        CHECK(program.error().fault == Fault::kScene);
    }
}

TEST_CASE("measured bytes do not depend on the number of threads") {
    const Solid solid = carved_cube();
    MeasureOptions options;
    options.lines = 20'000;
    const auto run = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return measured(solid, options);
    };
    const Measurement one = run(1), three = run(3);
    CHECK(one.volume.value == three.volume.value);
    CHECK(one.volume.error == three.volume.error);
    CHECK(one.area.value == three.area.value);
    for (std::size_t i = 0; i < 9; ++i) CHECK(one.inertia[i].value == three.inertia[i].value);
    CHECK(one.counters.primitive_tests == three.counters.primitive_tests);
}

TEST_CASE("99 % intervals cover the truth in 98 to 100 of 100 seeds, without bias") {
    const Solid solid = carved_cube();
    const auto program = compiled(solid);
    const double c = 6, r = 13.5, a = 20, k = r - a / 2;
    const double v = 4 / 3.0 * M_PI * r * r * r - 6 * M_PI * k * k * (r - k / 3) - (3 * M_PI * c * c * a - 16 * c * c * c + 8 * (2 - std::sqrt(2)) * c * c * c);
    int covered = 0;
    double sum = 0, squares = 0;
    constexpr int kSeeds = 300;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        MeasureOptions options;
        options.seed = seed;
        options.lines = 3 * 16 * 128;
        options.allow_exact = false;
        const auto m = measure(solid, *program, options);
        REQUIRE(m);
        covered += std::fabs(m->volume.value - v) <= m->volume.error;
        sum += m->volume.value - v;
        squares += (m->volume.value - v) * (m->volume.value - v);
    }
    CHECK(covered >= 290);  // 297 expected; fewer than 290 has probability 3e-4
    CHECK(std::fabs(sum / kSeeds) <= 4 * std::sqrt(squares) / kSeeds);
}
