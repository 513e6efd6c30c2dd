// rays.h — programs and seeded rays for the engine's tests.
#pragma once

#include <random>

#include <catch2/catch.hpp>

#include "tracer/engine/engine.h"

namespace whittle::testing {

inline std::shared_ptr<const Program> compiled(const Solid& solid, const EngineOptions& options = {}) {
    auto program = compile(solid, options);
    if (!program) FAIL(program.error().message);
    return *program;
}

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double between(double a, double b) { return a + (b - a) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
    Vec3 point(const Bounds& box) { return {between(box.lo.x, box.hi.x), between(box.lo.y, box.hi.y), between(box.lo.z, box.hi.z)}; }
    // From a point of a box three times as large through one of the box.
    Ray ray_through(const Bounds& box) {
        const Vec3 size = box.hi - box.lo;
        const Vec3 from = point({box.lo - size, box.hi + size}), to = point(box);
        Ray ray;
        ray.origin = from;
        ray.direction = to - from;
        return ray;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace whittle::testing
