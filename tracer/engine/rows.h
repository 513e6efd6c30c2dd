// rows.h — rays and hits side by side: a row a coordinate, so that packets read and write whole vectors.
//
// A Ray and a Hit are 72 and 128 bytes, of which a camera's first hit needs 48 and about 50; taking them apart one by one cost as much as meeting a small
// solid.
#pragma once

#include <array>
#include <cstdint>

#include "tracer/engine/engine.h"

namespace whittle {

// By axis, by ray. The rays start on no surface that they know of, at time 0.
struct RayRows {
    std::array<const double*, 3> origin{}, direction{};
    Ray ray(int i) const {
        return {{origin[0][i], origin[1][i], origin[2][i]}, {direction[0][i], direction[1][i], direction[2][i]}};
    }
};

// What a first hit tells, by ray, into memory of the caller's. t is +inf where nothing is met; the others are numbers only where something is.
struct HitRows {
    double* t = nullptr;
    double* t_error = nullptr;
    std::array<double*, 3> normal{};
    ClassId* surface = nullptr;
    std::uint32_t* use = nullptr;
};

// first_hit() of `count` rays, to the bit. Order and sizes as first_hits() of engine.h likes them.
void first_hits(const Program& program, const RayRows& rays, int count, double t_max, Scratch& scratch, const HitRows& hits);
// any_hit() of `count` rays, each up to its own t_max.
void any_hits(const Program& program, const RayRows& rays, const double* t_max, int count, Scratch& scratch, bool* blocked);

}  // namespace whittle
