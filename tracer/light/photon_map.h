// photon_map.h — light that arrived on dull surfaces, found again by place.
//
// A grid of cells as wide as the search is kept as one sorted array: building and asking depend on nothing but the photons and their order.
// Source: Jensen, Global Illumination using Photon Maps (1996).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/light/bsdf.h"

namespace whittle {

struct Photon {
    Vec3 point{0};
    Vec3 towards{0};  // the light, unit
    Vec3 normal{0};
    Vec3 power{0};
};

class PhotonMap {
public:
    PhotonMap() = default;
    // Requires: radius > 0.
    PhotonMap(std::vector<Photon> photons, double radius);

    // Radiance that the photons around `point` make towards the viewer of `bsdf`.
    Vec3 radiance(Vec3 point, Vec3 normal, const Bsdf& bsdf) const;
    const std::vector<Photon>& photons() const { return photons_; }

private:
    using Cell = std::array<std::int64_t, 3>;
    Cell cell_of(Vec3 p) const;
    std::size_t slot_of(const Cell& cell) const;

    std::vector<Photon> photons_;       // by slot
    std::vector<std::uint32_t> begin_;  // of each slot
    double radius_ = 0;
};

}  // namespace whittle
