// turned_angle.h — sine and cosine with bounds of their errors; no library decides. Private to the engine.
#pragma once

#include "tracer/engine/turned_function.h"

namespace whittle::turned {

Near half_pi(const Near&);
Bounded half_pi(const Bounded&);

// By how much a twist turns over a length of its axis, in radians.
template <class N>
N rate(const Twist& w) {
    return N(w.degrees) * half_pi(N()) / (N(90.0) * (N(w.z1) - N(w.z0)));
}

// False: the angle is out of all proportion.
bool turn(const Near& angle, Near& cosine, Near& sine);
bool turn(const Bounded& angle, Bounded& cosine, Bounded& sine);

}  // namespace whittle::turned
