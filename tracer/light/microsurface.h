// microsurface.h — rough clear matter: a ray walks among the microfacets of a border until it leaves them, on the one side or the other.
//
// Counting one bounce only loses up to a third of the light at a rough border. The walk loses none and is reciprocal in the mean. It gives directions, not
// densities: who needs those (lamps sampled at the border) has lobes in bsdf.h.
// Source: Heitz, Hanika, d'Eon, Dachsbacher, Multiple-Scattering Microfacet BSDFs with the Smith Model (2016).
#pragma once

#include <array>
#include <cstdint>

#include "csg/base/vec.h"

namespace whittle {

// Numbers in [0, 1) without end, from a pair that is well distributed itself.
class Stream {
public:
    explicit Stream(Vec2 seed);
    double next();

private:
    std::uint32_t key_, count_ = 0;
};

struct MicroWalk {
    bool left = false;   // false: lost, after more bounces than any ray needs
    bool through = false;
    bool bent = false;   // it was refracted at least once
    Vec3 direction{0};
    std::array<double, 4> mirrored{1, 1, 1, 1};  // probability of its reflections, for each index
};

// `direction` travels towards the surface, `normal` against it; `etas` are index before over index behind, the first decides. `alpha` > 0.
MicroWalk walk_microsurface(Vec3 direction, Vec3 normal, const std::array<double, 4>& etas, double alpha, Vec2 u, Stream stream);

}  // namespace whittle
