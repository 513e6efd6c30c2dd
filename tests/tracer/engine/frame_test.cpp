// frame_test.cpp — the rounded inverse of a placement, against the exact one.
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "tracer/engine/dyadic.h"
#include "tracer/engine/support.h"

using namespace whittle;
using exact::Dyadic;

namespace {

Dyadic size_of(const Dyadic& x) { return x.sign() < 0 ? -x : x; }

// Turns about x by `a` and then about y by `b`, entries rounded once: minors that are zero for exact entries nearly cancel.
Placement turned(double a, double b) {
    const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
    return {{cb, sb * sa, sb * ca, 1, 0, ca, -sa, 2, -sb, cb * sa, cb * ca, 3}};
}

}  // namespace

TEST_CASE("every entry of a frame's inverse is the exact one rounded") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    int cancelled = 0;
    for (int k = 0; k < 3000; ++k) {
        Placement p = turned(k % 7 * 0.1, k % 5 * 0.2);
        if (k % 3 == 0)
            for (double& x : p.m) x = number(random) * std::ldexp(1.0, static_cast<int>(random() % 61) - 30);
        if (k % 6 == 0) p.m[static_cast<std::size_t>(random() % 3)] = 0;
        if (k % 50 == 1) p.m[5] = std::ldexp(p.m[5], -1000);  // products underflow
        if (k % 50 == 2) p.m[10] = std::nextafter(p.m[6] * p.m[9] / p.m[5], 9e9);  // a minor that is nearly zero
        const Frame frame = make_frame(p);
        for (int j = 0; j < 3; ++j) {
            Vec3 axis(0);
            axis[j] = 1;
            const auto line = line_in_frame<Dyadic>(frame, {Dyadic(0.0), Dyadic(0.0), Dyadic(0.0)}, axis);
            REQUIRE(line.w.sign() > 0);
            for (std::size_t i = 0; i < 3; ++i) {
                const double got = frame.inverse[3 * i + static_cast<std::size_t>(j)];
                INFO("placement " << k << ", entry " << i << " " << j << ": " << got);
                if (!std::isnormal(got) && got != 0) continue;
                CHECK(size_of(Dyadic(got) * line.w - line.d[i]) <= size_of(line.d[i]).scaled(-53) + size_of(line.d[i]).scaled(-63));
                cancelled += std::abs(got) < 1e-12 && got != 0;
            }
        }
    }
    CHECK(cancelled > 100);
}
