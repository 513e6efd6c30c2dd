// chord_sums.h — integrals over a solid and its surface, gathered chord by chord.
#pragma once

#include <array>
#include <cstdint>

#include "csg/span/ray.h"

namespace whittle {

// Integrals relative to one origin. `second` holds xx, yy, zz, xy, xz, yz. `slack` bounds how far the ends' own errors move `volume`.
struct ChordSums {
    double volume = 0;
    Vec3 first{0};
    std::array<double, 6> second{};
    double area = 0;
    double slack = 0;
    bool unbounded = false;

    ChordSums& operator+=(const ChordSums& o);
    ChordSums scaled(double factor) const;
};

// Adds one line's chords. `ray` is the line, its direction of unit length up to rounding; positions count from `origin`.
void add_chords(ChordSums& sums, const Ray& ray, const Spans& spans, Vec3 origin);

}  // namespace whittle
