#include "csg/base/degrees.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include <mpfr.h>

using namespace whittle;

namespace {

double correctly_rounded(int (*function)(mpfr_t, const mpfr_t, mpfr_rnd_t), double x) {
    mpfr_t in, out;
    mpfr_init2(in, 53);
    mpfr_init2(out, 53);
    mpfr_set_d(in, x, MPFR_RNDN);
    function(out, in, MPFR_RNDN);
    const double y = mpfr_get_d(out, MPFR_RNDN);
    mpfr_clear(in);
    mpfr_clear(out);
    return y;
}

}  // namespace

TEST_CASE("sine and cosine are exact at multiples of 30 and 45 degrees") {
    CHECK(sind(0) == 0);
    CHECK(sind(30) == 0.5);
    CHECK(sind(45) == cosd(45));
    CHECK(sind(90) == 1);
    CHECK(sind(180) == 0);
    CHECK(sind(-30) == -0.5);
    CHECK(sind(330) == -0.5);
    CHECK(cosd(60) == 0.5);
    CHECK(cosd(90) == 0);
    CHECK(cosd(120) == -0.5);
    CHECK(cosd(180) == -1);
    CHECK(cosd(360 * 1e6 + 60) == 0.5);
    CHECK(sind(60) == std::sqrt(3.0) / 2);
}

TEST_CASE("an angle without digits left has no sine") {
    CHECK(std::isnan(sind(std::numeric_limits<double>::infinity())));
    CHECK(std::isnan(cosd(std::nan(""))));
    CHECK(std::isnan(sind(360.0 * 4503599627370496.0)));
    CHECK(std::isnan(cosd(-360.0 * 4503599627370496.0)));
}

TEST_CASE("below 45 degrees sine and cosine are the correctly rounded values of the rounded radians") {
    int wrong = 0;
    for (int n = 3; n < 400; ++n)
        for (int i = 0; i <= n; ++i) {
            const double deg = 360.0 * i / n;
            if (deg >= 45 || deg == 30) continue;
            wrong += sind(deg) != correctly_rounded(mpfr_sin, deg * kRadiansPerDegree);
            wrong += cosd(deg) != correctly_rounded(mpfr_cos, deg * kRadiansPerDegree);
        }
    CHECK(wrong == 0);
}
