// packets.h — packets of rays against the same rays one by one, to the bit.
#pragma once

#include <cstring>
#include <memory>
#include <vector>

#include "tests/tracer/engine/rays.h"
#include "tracer/engine/engine.h"
#include "tracer/engine/rows.h"

namespace whittle::testing {

inline bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline bool same_bits(const Vec3& a, const Vec3& b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z); }

inline bool same_bits(const Hit& a, const Hit& b) {
    if (a.departure.count != b.departure.count) return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(a.departure.count); ++i)
        if (a.departure.classes[i] != b.departure.classes[i]) return false;
    return same_bits(a.end.t, b.end.t) && same_bits(a.end.t_error, b.end.t_error) && same_bits(a.end.normal, b.end.normal) && same_bits(a.point, b.point) &&
           a.end.surface == b.end.surface && a.end.use == b.end.use && a.end.certified == b.end.certified && a.from_inside == b.from_inside;
}

// A tile around a ray: the ray itself, and neighbours whose directions are turned by multiples of `step`, all from its origin.
inline std::vector<Ray> tile_around(const Ray& ray, int count, double step) {
    std::vector<Ray> rays;
    const double l = glm::length(ray.direction);
    for (int i = 0; i < count; ++i) {
        Ray r = ray;
        r.departure = nullptr;
        r.direction += l * step * Vec3(i % 16, i / 16, (i * 7) % 5);
        rays.push_back(r);
    }
    return rays;
}

struct Tally {
    std::uint64_t hits = 0, in_packets = 0;
};

// Rays whose hit in rows differs from that of `hits`.
inline int differing_in_rows(const Program& program, const std::vector<Ray>& rays, double t_max, const std::vector<Hit>& hits, const bool* found) {
    const std::size_t n = rays.size();
    std::array<std::vector<double>, 6> from;
    for (std::size_t i = 0; i < 6; ++i)
        for (const Ray& ray : rays) from[i].push_back(i < 3 ? ray.origin[static_cast<int>(i)] : ray.direction[static_cast<int>(i - 3)]);
    std::vector<double> t(n), error(n), x(n), y(n), z(n), far(n, t_max);
    std::vector<ClassId> surface(n);
    std::vector<std::uint32_t> use(n);
    const auto blocked = std::make_unique<bool[]>(n);
    const RayRows rows{{from[0].data(), from[1].data(), from[2].data()}, {from[3].data(), from[4].data(), from[5].data()}};
    Scratch scratch;
    first_hits(program, rows, static_cast<int>(n), t_max, scratch, {t.data(), error.data(), {x.data(), y.data(), z.data()}, surface.data(), use.data()});
    any_hits(program, rows, far.data(), static_cast<int>(n), scratch, blocked.get());
    int wrong = 0;
    for (std::size_t i = 0; i < n; ++i) {
        wrong += blocked[i] != any_hit(program, rays[i], t_max, scratch);
        wrong += found[i] != (t[i] < HUGE_VAL);
        if (!found[i]) continue;
        const End& end = hits[i].end;
        wrong += !same_bits(end.t, t[i]) || !same_bits(end.t_error, error[i]) || !same_bits(end.normal, {x[i], y[i], z[i]}) || end.surface != surface[i] || end.use != use[i];
    }
    return wrong;
}

// Rays whose packet answer differs from the single one.
inline int differing(const Program& program, const std::vector<Ray>& rays, double t_max, Tally& tally) {
    Scratch a, b;
    std::vector<Hit> many(rays.size());
    const auto found = std::make_unique<bool[]>(rays.size());
    first_hits(program, rays.data(), static_cast<int>(rays.size()), t_max, a, many.data(), found.get());
    int wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Hit one;
        const bool is = first_hit(program, rays[i], t_max, b, one);
        tally.hits += is;
        wrong += is != found[i] || (is && !same_bits(one, many[i]));
    }
    tally.in_packets += a.counters.packet_rays;
    return wrong + differing_in_rows(program, rays, t_max, many, found.get());
}

}  // namespace whittle::testing
