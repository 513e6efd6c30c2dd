// membership.h — spans on a ray against membership of points in 113-bit arithmetic.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/tracer/engine/rays.h"

namespace whittle::testing {

__extension__ using Quad = __float128;

struct Turn {
    Quad c = 1, s = 0;
};

// By the series of the angle halved until it is small, and doubled again.
inline Turn turn_by(Quad radians) {
    int halvings = 0;
    while (radians > 0.25 || radians < -0.25) radians /= 2, ++halvings;
    Quad c = 1, s = radians, even = 1, odd = radians;
    for (int n = 2; n < 36; n += 2) {
        even *= -radians * radians / (n * (n - 1));
        odd *= -radians * radians / (n * (n + 1));
        c += even;
        s += odd;
    }
    while (halvings-- > 0) {
        const Quad double_s = 2 * s * c;
        c = 1 - 2 * s * s;
        s = double_s;
    }
    return {c, s};
}

inline std::vector<std::pair<End, bool>> ends_of(const Spans& spans) {
    std::vector<std::pair<End, bool>> ends;
    for (const Span& s : spans) {
        if (s.in) ends.emplace_back(*s.in, true);
        if (s.out) ends.emplace_back(*s.out, false);
    }
    return ends;
}

// Where the spans are not those of the set {t : inside(t)} in [0, far); empty if nowhere. It must change between a little before each end and a little behind it, by
// the end's own bound, and nowhere else as far as samples see.
template <class Inside>
std::string difference(const Inside& inside, const Spans& spans, Random& random, double far = 2) {
    const auto ends = ends_of(spans);
    for (const auto& [e, enters] : ends)
        if (inside(Quad(e.t) - e.t_error) == enters || inside(Quad(e.t) + e.t_error) != enters) return "no change at " + std::to_string(e.t);
    for (int i = 0; i < 200; ++i) {
        const double t = random.between(0, far);
        bool in = !spans.empty() && !spans[0].in, near = false;
        for (const auto& [e, enters] : ends) {
            if (e.t <= t) in = enters;
            near = near || std::abs(t - e.t) <= 2 * e.t_error;
        }
        if (!near && in != inside(t)) return "otherwise at " + std::to_string(t);
    }
    return "";
}

}  // namespace whittle::testing
