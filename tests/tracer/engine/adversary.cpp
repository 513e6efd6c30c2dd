// adversary.cpp — see adversary.h.
#include "tests/tracer/engine/adversary.h"

#include <cmath>
#include <numeric>

#include "tests/tracer/engine/judge.h"

namespace whittle::testing {

namespace {

std::int64_t integer(Random& random, std::int64_t least, std::int64_t most) {
    return least + static_cast<std::int64_t>(random.between(0, static_cast<double>(most - least + 1)));
}

bool is_round(SupportKind k) { return !is_plane(k); }

int count_of(const Question& q, const Frame& frame) {
    Crossings c;
    if (filtered_crossings(q.support, ray_in_frame(frame, q.ray), c)) return c.count;
    return judged(q.support, frame, q.ray, false).count;
}

Question random_question(SupportKind kind, Random& random) {
    Question q{random_support(kind, random), random_placement(random), random_ray(random)};
    // Rays are made for the frame's own space most of the time, so that they meet something.
    if (random.between(0, 1) < 0.7 && !q.placement.is_identity()) {
        q.ray.origin = apply_to_point(q.placement, q.ray.origin);
        q.ray.direction = apply_to_direction(q.placement, q.ray.direction);
    }
    return q;
}

Question grazing(SupportKind kind, Random& random) {
    Question q = random_question(kind, random);
    const Frame frame = make_frame(q.placement);
    Question other = q;
    other.ray.direction = on_sphere(random) * glm::length(q.ray.direction);
    const int here = count_of(q, frame);
    if (count_of(other, frame) == here) return q;
    for (int i = 0; i < 70; ++i) {
        Question middle = q;
        middle.ray.direction = 0.5 * (q.ray.direction + other.ray.direction);
        if (middle.ray.direction == q.ray.direction || middle.ray.direction == other.ray.direction) break;
        (count_of(middle, frame) == here ? q : other) = middle;
    }
    return random.between(0, 1) < 0.5 ? q : other;
}

// Integers with r^2 n - c^2 small: a convergent c/r of the square root of n.
struct Convergent {
    std::int64_t c, r;
};
Convergent convergent(std::int64_t n, double r_least) {
    const auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
    std::int64_t m = 0, d = 1, a = root, c0 = 1, c1 = root, r0 = 0, r1 = 1;
    while (static_cast<double>(r1) < r_least) {
        m = d * a - m;
        d = (n - m * m) / d;
        a = (root + m) / d;
        const std::int64_t c2 = a * c1 + c0, r2 = a * r1 + r0;
        c0 = c1, c1 = c2, r0 = r1, r1 = r2;
    }
    return {c1, r1};
}

// x dy - y dx = c for coprime dx, dy, with x in 0 ... dx - 1.
void solve(std::int64_t dx, std::int64_t dy, std::int64_t c, double& x, double& y) {
    for (std::int64_t k = 0; k < dx; ++k)
        if ((k * dy - c) % dx == 0) {
            x = static_cast<double>(k);
            y = static_cast<double>((k * dy - c) / dx);
            return;
        }
    x = 0;
    y = -static_cast<double>(c) / static_cast<double>(dx);
}

// The support whose section across `axis` at height 0 is the circle of radius r about the axis. False: the kind has none.
bool circle_support(Support& s, double r, Random& random) {
    const auto u = (s.axis + 1u) % 3, v = (s.axis + 2u) % 3;
    s.p = {};
    switch (s.kind) {
        case SupportKind::kBall: s.p[3] = r; return true;
        case SupportKind::kEllipsoid: s.p[3] = s.p[4] = s.p[5] = r; return true;
        case SupportKind::kCylinder: s.p[2] = r; return true;
        case SupportKind::kCone:
            s.p[3] = r;
            s.p[4] = r;
            s.p[5] = r * random.between(0.1, 2);
            return true;
        case SupportKind::kTube:
            s.p[3 + s.axis] = 1;
            s.p[6] = r;
            return true;
        case SupportKind::kQuadric:
            s.p[u] = s.p[v] = 1;
            s.p[9] = -(r * r);
            return true;
        case SupportKind::kTorus:
            s.p[4] = std::floor(r * random.between(0.1, 0.4));
            s.p[3] = random.between(0, 1) < 0.5 ? r - s.p[4] : r + s.p[4];  // its outer or its inner circle
            return true;
        default: return false;
    }
}

Question pell(SupportKind kind, Random& random) {
    Question q;
    q.support.kind = kind;
    q.support.axis = static_cast<std::uint8_t>(integer(random, 0, 2));
    std::int64_t dx = 0, dy = 0, n = 0, root = 0;
    do {
        dx = integer(random, 1, 40);
        dy = integer(random, 1, 40);
        n = dx * dx + dy * dy;
        root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
    } while (std::gcd(dx, dy) != 1 || root * root == n);
    const bool narrow = kind == SupportKind::kQuadric;  // r^2 must be a double
    const Convergent k = convergent(n, std::exp2(random.between(3, narrow ? 20 : 45)));
    double x = 0, y = 0;
    solve(dx, dy, k.c, x, y);
    const double scale = std::exp2(static_cast<double>(integer(random, -60, 20)));
    if (!circle_support(q.support, static_cast<double>(k.r) * scale, random)) return random_question(kind, random);
    const int u = (q.support.axis + 1) % 3, v = (q.support.axis + 2) % 3;
    q.ray.origin = Vec3(0);
    q.ray.direction = Vec3(0);
    q.ray.origin[u] = x * scale;
    q.ray.origin[v] = y * scale;
    q.ray.direction[u] = static_cast<double>(dx);
    q.ray.direction[v] = static_cast<double>(dy);
    const int bit = static_cast<int>(integer(random, 0, 5));
    if (bit == 0) q.ray.origin[u] = std::nextafter(q.ray.origin[u], HUGE_VAL);
    if (bit == 1) q.ray.origin[v] = std::nextafter(q.ray.origin[v], -HUGE_VAL);
    return q;
}

// Numbers of 20 bits, so that points along the ray are exact.
Vec3 short_vector(Random& random) {
    Vec3 v;
    do
        for (int i = 0; i < 3; ++i) v[i] = static_cast<double>(integer(random, -1000, 1000)) * 0x1p-10;
    while (v.x == 0 || v.y == 0 || v.z == 0);
    return v;
}

Question thin(SupportKind kind, Random& random) {
    Question q;
    Support& s = q.support;
    s = random_support(kind, random);
    const Vec3 centre = kind == SupportKind::kQuadric ? Vec3(0) : short_vector(random);
    const double r = random.between(0.01, 2) * 0x1p-52;
    const int u = (s.axis + 1) % 3, v = (s.axis + 2) % 3;
    for (int i = 0; i < 3; ++i) s.p[static_cast<std::size_t>(i)] = centre[i];
    switch (kind) {
        case SupportKind::kBall: s.p[3] = r; break;
        case SupportKind::kEllipsoid: s.p[3] = r, s.p[4] = r * 0.7, s.p[5] = r * 1.3; break;
        case SupportKind::kCylinder: s.p[0] = centre[u], s.p[1] = centre[v], s.p[2] = r; break;
        case SupportKind::kCone:
            s.p[0] = centre[u], s.p[1] = centre[v], s.p[2] = centre[s.axis] - 1, s.p[3] = centre[s.axis] + 1, s.p[4] = r, s.p[5] = 1.5 * r;
            break;
        case SupportKind::kTube:
            for (int i = 0; i < 3; ++i) s.p[static_cast<std::size_t>(3 + i)] = centre[i] + static_cast<double>(integer(random, 1, 9));
            s.p[6] = r;
            break;
        case SupportKind::kQuadric: s.p = {1, 1.25, 0.75, 0, 0, 0, 0, 0, 0, -(r * r)}; break;
        case SupportKind::kTorus: s.p[3] = r * random.between(0.1, 0.9), s.p[4] = r; break;
        case SupportKind::kTorusCore: s.p[3] = r * 0.5, s.p[4] = r; break;
        default: return random_question(kind, random);
    }
    q.ray.direction = short_vector(random);
    q.ray.origin = centre - static_cast<double>(integer(random, 1, 7)) * q.ray.direction;
    return q;
}

}  // namespace

const char* name_of(SupportKind kind) {
    static constexpr std::array<const char*, kSupportKinds> names{"axis plane", "plane", "plane of points", "plane of an edge", "ball", "ellipsoid", "cylinder", "cone",
                                                                  "tube", "quadric", "torus", "torus core", "parabola"};
    return names[static_cast<std::size_t>(kind)];
}

const char* name_of(Sort sort) {
    static constexpr std::array<const char*, kSorts> names{"random", "grazing", "pell", "thin"};
    return names[static_cast<std::size_t>(sort)];
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

Question ask(Sort sort, SupportKind kind, Random& random) {
    if (!is_round(kind) || sort == Sort::kRandom) return random_question(kind, random);
    if (sort == Sort::kGrazing) return grazing(kind, random);
    return sort == Sort::kPell ? pell(kind, random) : thin(kind, random);
}

Support plane_near(const Ray& ray, double t, double ulps, Random& random) {
    Support s;
    s.kind = SupportKind::kPlane;
    const Vec3 n = on_sphere(random), at = point_at(ray, t * (1 + ulps * 0x1p-52));
    s.p = {n.x, n.y, n.z, glm::dot(n, at)};
    return s;
}

}  // namespace whittle::testing
