// roots_test.cpp — the double filter against exact arithmetic: what it decides is right, and every t lies within its bound.
//
// WHITTLE_ROUNDS multiplies the number of rays (1 by default: 20,000 a kind, tori 4,000).
#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/tracer/engine/rays.h"
#include "tracer/engine/exact_crossings.h"
#include "tracer/engine/torus_roots.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

std::uint64_t rounds() {
    const char* text = std::getenv("WHITTLE_ROUNDS");
    return text == nullptr ? 1 : std::max(1ull, std::strtoull(text, nullptr, 10));
}

// The polynomial of the roots' distances from t: p(t + s).
exact::Polynomial seen_from(const exact::Polynomial& p, double t) {
    exact::Polynomial r;
    for (std::size_t i = p.size(); i-- > 0;) {
        exact::Polynomial next(r.size() + 1);
        for (std::size_t k = 0; k < r.size(); ++k) {
            next[k + 1] = next[k + 1] + r[k];
            next[k] = next[k] + r[k] * exact::Dyadic(t);
        }
        if (next.empty()) next.resize(1);
        next[0] = next[0] + p[i];
        r = std::move(next);
    }
    exact::normalise(r);
    return r;
}

Vec3 on_sphere(Random& random) {
    while (true) {
        const Vec3 v = random.point({Vec3(-1), Vec3(1)});
        const double n = glm::length(v);
        if (n > 0.1 && n < 1) return v / n;
    }
}

Placement random_placement(Random& random) {
    Placement p;
    const double kind = random.between(0, 3);
    if (kind < 1) return p;
    for (double& x : p.m) x = random.between(-1, 1);
    if (kind < 2)
        for (std::size_t i = 3; i < 12; i += 4) p.m[i] *= 1e6;
    return p;
}

Support random_support(SupportKind kind, Random& random) {
    Support s;
    s.kind = kind;
    s.axis = static_cast<std::uint8_t>(random.between(0, 3));
    for (double& x : s.p) x = random.between(-1, 1);
    const auto positive = [&](std::size_t i) { s.p[i] = std::abs(s.p[i]) + 0.01; };
    if (kind == SupportKind::kBall) positive(3);
    if (kind == SupportKind::kEllipsoid) positive(3), positive(4), positive(5);
    if (kind == SupportKind::kCylinder) positive(2);
    if (kind == SupportKind::kCone) s.p[3] = s.p[2] + std::abs(s.p[3]) + 0.1, positive(4), positive(5);
    if (kind == SupportKind::kTube) positive(6);
    if (kind == SupportKind::kTorus || kind == SupportKind::kTorusCore) positive(3), positive(4);
    return s;
}

// Rays of all sorts: general, through the support's middle, parallel to an axis, and moved so that they graze.
Ray random_ray(Random& random) {
    Ray ray;
    ray.origin = 3.0 * on_sphere(random);
    ray.direction = on_sphere(random) * 0.9 - ray.origin;
    const double kind = random.between(0, 8);
    if (kind < 1) {
        const int axis = static_cast<int>(random.between(0, 3));
        ray.direction = Vec3(0);
        ray.direction[axis] = 1;
        ray.origin[axis] = -4;
        ray.origin[(axis + 1) % 3] *= 0.3;
        ray.origin[(axis + 2) % 3] *= 0.3;
    } else if (kind < 2) {
        ray.origin *= 1e5;
        ray.direction = on_sphere(random) * 0.9 - ray.origin;
    } else if (kind < 3) {
        ray.direction *= 1e-7;
    }
    return ray;
}

struct Tally {
    std::vector<double> ratios;
    std::uint64_t undecided = 0, decided = 0;
};

void check(const Support& s, const Frame& frame, const Ray& ray, Tally& tally) {
    Crossings fast, truth;
    const bool decided = filtered_crossings(s, ray_in_frame(frame, ray), fast);
    const exact::Polynomial p = exact_polynomial(s, frame, ray, false);
    exact_crossings(s, frame, ray, false, truth);
    if (!decided) {
        ++tally.undecided;
        if (!fine_crossings(s, frame, ray, false, fast)) fast = truth;
    }
    ++tally.decided;
    REQUIRE(fast.count == truth.count);
    REQUIRE(fast.first_sign == truth.first_sign);
    for (std::size_t i = 0; i < static_cast<std::size_t>(fast.count); ++i) {
        const auto gaps = exact::sign_changes(seen_from(p, fast.t[i]));
        REQUIRE(gaps.size() == static_cast<std::size_t>(fast.count));
        double gap = 0, rounding = 0;
        gaps[i].approximate(gap, rounding);
        INFO("kind " << static_cast<int>(s.kind) << " crossing " << i << " t " << fast.t[i] << " gap " << gap << " bound " << fast.error[i]);
        REQUIRE(std::abs(gap) <= fast.error[i]);
        if (decided && gap != 0 && frame.identity) tally.ratios.push_back(fast.error[i] / std::abs(gap));
    }
}

// Turns the ray about its origin until it passes from two crossings to none, to the last bit: the closest to a tangent there is.
Ray grazing(const Support& s, const Frame& frame, Ray ray, Random& random) {
    Ray miss = ray;
    miss.direction = on_sphere(random) * glm::length(ray.direction);
    Crossings a, b;
    exact_crossings(s, frame, ray, false, a);
    exact_crossings(s, frame, miss, false, b);
    if (a.count == b.count) return ray;
    for (int i = 0; i < 60; ++i) {
        Ray middle = ray;
        middle.direction = 0.5 * (ray.direction + miss.direction);
        if (middle.direction == ray.direction || middle.direction == miss.direction) break;
        Crossings m;
        exact_crossings(s, frame, middle, false, m);
        (m.count == a.count ? ray : miss) = middle;
    }
    return random.between(0, 1) < 0.5 ? ray : miss;
}

void check_kind(SupportKind kind, std::uint64_t seed, std::uint64_t rays) {
    Random random(seed);
    Tally tally;
    for (std::uint64_t i = 0; i < rays; ++i) {
        const Support s = random_support(kind, random);
        const Frame frame = make_frame(random_placement(random));
        Ray ray = random_ray(random);
        // Rays are made for the frame's own space half of the time, so that they meet something.
        if (random.between(0, 1) < 0.7 && !frame.identity) {
            ray.origin = apply_to_point(frame.placement, ray.origin);
            ray.direction = apply_to_direction(frame.placement, ray.direction);
        }
        check(s, frame, ray, tally);
        if (i % 10 == 0 && kind != SupportKind::kAxisPlane) check(s, frame, grazing(s, frame, ray, random), tally);
    }
    std::sort(tally.ratios.begin(), tally.ratios.end());
    REQUIRE(tally.ratios.size() > rays / 20);
    const double median = tally.ratios[tally.ratios.size() / 2];
    WARN("kind " << static_cast<int>(kind) << ": " << tally.decided << " rays, " << tally.undecided << " undecided, median bound/error " << median << ", least "
                 << tally.ratios.front());
    CHECK(median <= 64);
}

}  // namespace

TEST_CASE("what the filter decides is exact and every t lies within its bound") {
    const auto kind = static_cast<SupportKind>(GENERATE(range(0, 12)));
    const bool torus = kind == SupportKind::kTorus;
    check_kind(kind, 100 + static_cast<std::uint64_t>(kind), (torus ? 1000 : 5000) * rounds());
}

TEST_CASE("a ray along a face takes the side of the perturbation, not of rounding") {
    Support plane;
    plane.p[0] = 1;
    const Frame identity = make_frame({});
    Ray ray;
    ray.origin = {1, 0, 0};
    ray.direction = {0, 1, 0};
    Crossings c;
    CHECK_FALSE(filtered_crossings(plane, ray_in_frame(identity, ray), c));
    exact_crossings(plane, identity, ray, false, c);
    CHECK(c.count == 0);
    CHECK(c.first_sign == 1);  // the first vector of the perturbation points to +x
}

TEST_CASE("a ray that leaves a surface has its origin as one crossing and the others within their bounds") {
    const auto kind = static_cast<SupportKind>(GENERATE(range(0, 12)));
    Random random(300 + static_cast<std::uint64_t>(kind));
    std::uint64_t decided = 0, met = 0;
    for (std::uint64_t i = 0; i < 3000 * rounds(); ++i) {
        const Support s = random_support(kind, random);
        const Frame frame = make_frame(random_placement(random));
        Ray ray = random_ray(random);
        ray.origin = apply_to_point(frame.placement, ray.origin);
        ray.direction = apply_to_direction(frame.placement, ray.direction);
        Crossings on, fast, truth;
        exact_crossings(s, frame, ray, false, on);
        if (on.count == 0) continue;
        ray.origin = point_at(ray, on.t[0]);
        ray.direction = on_sphere(random);
        ++met;
        exact_crossings(s, frame, ray, true, truth);
        if (!filtered_departure(s, ray_in_frame(frame, ray), fast)) continue;
        ++decided;
        const exact::Polynomial p = exact_polynomial(s, frame, ray, true);
        REQUIRE(fast.count == truth.count);
        REQUIRE(fast.first_sign == truth.first_sign);
        bool at_zero = false;
        for (std::size_t k = 0; k < static_cast<std::size_t>(fast.count); ++k) {
            at_zero = at_zero || (fast.t[k] == 0 && fast.error[k] == 0);
            double gap = 0, rounding = 0;
            exact::sign_changes(seen_from(p, fast.t[k]))[k].approximate(gap, rounding);
            REQUIRE(std::abs(gap) <= fast.error[k]);
        }
        REQUIRE(at_zero);
    }
    CHECK(decided > met * 9 / 10);
    CHECK(met > 300);
}
