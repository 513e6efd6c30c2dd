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

// The function of a side on the line o + t d of its frame, in powers of what t is moved by. All of it 0, certainty included: the angle is out of all proportion.
// Requires: the rate is that of the twist, if it turns.
template <std::size_t K, class N>
Taylor<N, K> on_line(const Support& support, const Twist& twist, const N& rate, const std::array<N, 3>& o, const std::array<N, 3>& d, const N& t) {
    using T = Taylor<N, K>;
    std::array<T, 3> x;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i].c[0] = o[i] + t * d[i];
        if constexpr (K > 0) x[i].c[1] = d[i];
    }
    T cosine(N(1.0)), sine;
    if (twist.degrees != 0) {
        N c, s;
        if (!turn(rate * (x[2].c[0] - N(twist.z0)), c, s)) return {};
        // The derivatives go around: -s, -c, s, c.
        const N speed = rate * d[2];
        N power(1.0);
        for (std::size_t k = 0; k <= K; ++k) {
            cosine.c[k] = power * (k % 4 == 0 ? c : k % 4 == 1 ? -s : k % 4 == 2 ? -c : s);
            sine.c[k] = power * (k % 4 == 0 ? s : k % 4 == 1 ? c : k % 4 == 2 ? -s : -c);
            power = power * speed / N(static_cast<double>(k + 1));
        }
    }
    return function(support, twist, x, cosine, sine);
}

}  // namespace whittle::turned
