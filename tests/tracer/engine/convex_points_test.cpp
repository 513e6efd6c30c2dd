// convex_points_test.cpp — every certified end of any convex body against membership of points in 113-bit arithmetic: outside before it, inside behind it, by the
// end's own bound.
//
// Whether a point is in a body is decided by Gilbert, Johnson and Keerthi's distance from it: a tetrahedron of points of the body around it, or a direction in
// which the whole body lies beyond; both are proofs. The engine walks along the ray and measures no distance. Source: Gilbert, Johnson and Keerthi, A fast
// procedure for computing the distance between complex objects in three-dimensional space (1988).
//
// WHITTLE_RAYS=1000000 test_tracer_engine "every end of a convex body*"
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "csg/solid/convex_body.h"
#include "csg/solid/use_of.h"
#include "tests/support/seed.h"
#include "tests/tracer/engine/rays.h"

using namespace whittle;
using namespace whittle::testing;

namespace {

__extension__ using Quad = __float128;
using Place = std::array<Quad, 3>;

Place operator+(const Place& a, const Place& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Place operator-(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Place operator*(Quad k, const Place& a) { return {k * a[0], k * a[1], k * a[2]}; }
Quad dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place cross(const Place& a, const Place& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
Quad root(Quad a) {
    if (!(a > 0)) return 0;
    Quad s = std::sqrt(static_cast<double>(a));
    for (int i = 0; i < 2; ++i) s = (s + a / s) / 2;
    return s;
}

// A body where it is placed, by the numbers of its parts and placement as they are.
class Body {
public:
    Body(const ConvexParts& parts, const Placement& at) {
        const auto turned = [&](const Vec3& d) {
            Place r{};
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) r[static_cast<std::size_t>(i)] += Quad(at.linear(i, j)) * d[j];
            return r;
        };
        for (const ConvexPart& part : parts) {
            Part& p = parts_.emplace_back();
            p.centre = turned(part.centre) + Place{at.offset(0), at.offset(1), at.offset(2)};
            for (const BallImage& i : part.images) p.images.push_back({turned(i.u), turned(i.v), turned(i.w)});
        }
    }

    // Strictly inside, strictly outside, or on the border as far as 113 bits tell.
    std::optional<bool> holds(const Place& p) const {
        std::vector<Place> simplex{farthest({1, 0, 0}) - p};
        for (int step = 0; step < 2000; ++step) {
            const std::optional<Place> nearest = nearest_of(simplex);
            if (!nearest) return true;
            const Place w = farthest(Quad(-1) * *nearest) - p;
            const Quad beyond = dot(*nearest, w), square = dot(*nearest, *nearest);
            if (beyond > 0) return false;
            if (!(square > 1e-60)) return std::nullopt;
            simplex.push_back(w);
        }
        return std::nullopt;
    }

private:
    struct Part {
        Place centre;
        std::vector<std::array<Place, 3>> images;
    };

    Place farthest(const Place& n) const {
        Place best{};
        Quad most = 0;
        bool first = true;
        for (const Part& part : parts_) {
            Place p = part.centre;
            for (const auto& image : part.images) {
                const Quad x = dot(n, image[0]), y = dot(n, image[1]), z = dot(n, image[2]), length = root(x * x + y * y + z * z);
                if (length > 0) p = p + (x / length) * image[0] + (y / length) * image[1] + (z / length) * image[2];
            }
            if (const Quad reach = dot(n, p); first || reach > most) best = p, most = reach, first = false;
        }
        return best;
    }

    // The point of the simplex nearest to the origin, which is left with the corners it is made of; none where a tetrahedron holds the origin.
    static std::optional<Place> nearest_of(std::vector<Place>& simplex) {
        if (simplex.size() == 4 && holds_origin(simplex)) return std::nullopt;
        Quad least = -1;
        Place nearest{};
        std::vector<Place> kept;
        for (unsigned chosen = 1; chosen < (1u << simplex.size()); ++chosen) {
            std::vector<Place> corners;
            for (std::size_t i = 0; i < simplex.size(); ++i)
                if ((chosen >> i) & 1u) corners.push_back(simplex[i]);
            const auto p = foot(corners);
            if (!p || (least >= 0 && !(dot(*p, *p) < least))) continue;
            least = dot(*p, *p);
            nearest = *p;
            kept = corners;
        }
        simplex = kept;
        return nearest;
    }

    // Of the origin on the hull of one, two or three corners, if it lies within.
    static std::optional<Place> foot(const std::vector<Place>& c) {
        if (c.size() == 1) return c[0];
        if (c.size() > 3) return std::nullopt;
        const Place e = c[1] - c[0];
        if (c.size() == 2) {
            const Quad t = -dot(c[0], e), all = dot(e, e);
            if (!(t > 0 && t < all)) return std::nullopt;
            return c[0] + (t / all) * e;
        }
        const Place f = c[2] - c[0];
        const Quad ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), det = ee * ff - ef * ef, x = -dot(c[0], e), y = -dot(c[0], f);
        const Quad s = ff * x - ef * y, t = ee * y - ef * x;
        if (!(det > 0 && s > 0 && t > 0 && s + t < det)) return std::nullopt;
        const Place n = cross(e, f);
        return (dot(n, c[0]) / dot(n, n)) * n;
    }

    static bool holds_origin(const std::vector<Place>& c) {
        int signs[2] = {0, 0};
        for (std::size_t i = 0; i < 4; ++i) {
            const Place &a = c[(i + 1) % 4], &b = c[(i + 2) % 4], &d = c[(i + 3) % 4];
            const Place n = cross(b - a, d - a);
            const Quad own = dot(n, c[i] - a), origin = -dot(n, a);
            ++signs[own * origin > 0 ? 1 : 0];
        }
        return signs[1] == 4;
    }

    std::vector<Part> parts_;
};

ConvexParts random_parts(Random& random) {
    const auto vector = [&] { return Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)); };
    ConvexParts parts;
    const int count = 2 + static_cast<int>(random.between(0, 5));
    for (int i = 0; i < count; ++i) {
        ConvexPart& part = parts.emplace_back(ConvexPart{10.0 * vector(), {}});
        const double kind = random.between(0, 5);
        if (kind > 1) part.images.push_back({4.0 * vector(), 4.0 * vector(), kind > 3 ? 4.0 * vector() : Vec3(0)});
        if (kind > 4) part.images.push_back({2.0 * vector(), 2.0 * vector(), Vec3(0)});
    }
    parts.push_back({Vec3(0), {{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}}});
    return parts;
}

Placement random_placement(Random& random) {
    Placement p;
    for (double& x : p.m) x = random.between(-1, 1);
    for (const std::size_t i : {0u, 5u, 10u}) p.m[i] += p.m[i] < 0 ? -2 : 2;
    for (const std::size_t i : {3u, 7u, 11u}) p.m[i] *= 100;
    return p;
}

struct Tally {
    std::uint64_t rays = 0, ends = 0, certified = 0, undecided = 0;
    std::vector<double> ratios;  // bound over error
};

// Of the bound, how far the border lies from t: by halving.
double share_of(const Body& body, const Ray& ray, const End& end, bool enters) {
    Quad lo = -1, hi = 1;
    for (int i = 0; i < 24; ++i) {
        const Quad middle = (lo + hi) / 2, t = Quad(end.t) + middle * end.t_error;
        const auto inside = body.holds({ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y, ray.origin.z + t * ray.direction.z});
        if (!inside) break;
        (*inside == enters ? hi : lo) = middle;
    }
    return std::abs(static_cast<double>((lo + hi) / 2));
}

void check_body(Random& random, int rays, bool sampled, Tally& tally) {
    const ConvexParts parts = random_parts(random);
    const Placement at = random.between(0, 1) < 0.5 ? Placement{} : random_placement(random);
    SolidBuilder b;
    const auto program = compiled(b.finish(use_of(b.shape(shape::ConvexBody{std::make_shared<const ConvexHullBody>(parts)}), at)));
    const Body body(parts, at);
    Scratch scratch;
    for (int i = 0; i < rays; ++i) {
        Ray ray = random.ray_through(program_bounds(*program));
        // Some in a plane of symmetry of what is symmetric, towards the middles of parts.
        if (i % 4 == 0) ray.direction = apply_to_point(at, parts[static_cast<std::size_t>(random.between(0, static_cast<double>(parts.size())))].centre) - ray.origin;
        Spans spans;
        all_spans(*program, ray, scratch, spans);
        ++tally.rays;
        REQUIRE(spans.size() <= 1);
        for (const Span& s : spans)
            for (const bool enters : {true, false}) {
                if (enters && !s.in) continue;
                const End& end = enters ? *s.in : *s.out;
                ++tally.ends;
                tally.certified += end.certified;
                if (!end.certified) continue;
                const auto holds = [&](double sign) {
                    const Quad t = Quad(end.t) + Quad(sign) * end.t_error;
                    return body.holds({ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y, ray.origin.z + t * ray.direction.z});
                };
                const auto before = holds(-1), behind = holds(1);
                tally.undecided += !before || !behind;
                CHECK((!before || *before != enters));
                CHECK((!behind || *behind == enters));
                if (sampled && tally.ends % 10 == 0) tally.ratios.push_back(1 / std::max(1e-9, share_of(body, ray, end, enters)));
            }
    }
}

double median(std::vector<double>& list) {
    std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), list.end());
    return list[list.size() / 2];
}

}  // namespace

TEST_CASE("ends of hulls and sums of any images of balls lie within their bounds of membership's change") {
    const std::uint64_t seed = support::fresh_seed();
    CAPTURE(seed);
    Random random(seed);
    Tally tally;
    for (int round = 0; round < 12; ++round) check_body(random, 40, false, tally);
    CHECK(tally.ends > 200);
    CHECK(tally.certified * 10 > tally.ends * 9);  // some 97.5 %; bodies drawn differ by a few in a hundred
    CHECK(tally.undecided * 100 < tally.ends);
}

TEST_CASE("every end of a convex body is within its bound for as many rays as asked", "[.soak]") {
    const char* text = std::getenv("WHITTLE_RAYS");
    const std::uint64_t rays = text == nullptr ? 1'000'000 : std::strtoull(text, nullptr, 10), seed = support::fresh_seed();
    fmt::print("WHITTLE_SEED={}\n", seed);
    Random random(seed);
    Tally tally;
    while (tally.rays < rays) check_body(random, 100, true, tally);
    fmt::print("{} rays, {} ends, {} certified, {} of them undecided; bound/error {:.0f}\n", tally.rays, tally.ends, tally.certified, tally.undecided, median(tally.ratios));
}
