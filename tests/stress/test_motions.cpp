// test_motions.cpp — the events on a ray do not depend on where, how large or in which words a solid stands.
//
// Motions that doubles hold exactly give equal events. Motions written as text, with rays rounded to doubles, give equal events outside a mask: rays whose
// answer, by the exact reference, changes when they move by what the rounding of ray and placements can move them. WHITTLE_RAYS a scene and motion (300).
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/stress/compare.h"
#include "tests/stress/mask.h"
#include "tests/stress/scene_text.h"
#include "tests/support/reduce.h"
#include "tests/support/seed.h"

using namespace whittle;
using namespace whittle::stress;
using namespace whittle::support;

namespace {

using Long3 = std::array<long double, 3>;
using LongMatrix = std::array<Long3, 3>;

struct Event {
    double t, error;
    bool entering;
    std::uint32_t use;
};

std::vector<Event> events(const Program& program, const Ray& ray, Scratch& scratch) {
    Spans spans;
    all_spans(program, ray, scratch, spans);
    std::vector<Event> r;
    for (const Span& s : spans) {
        if (s.in) r.push_back({s.in->t, s.in->t_error, true, s.in->use});
        if (s.out) r.push_back({s.out->t, s.out->t_error, false, s.out->use});
    }
    return r;
}

std::string described(const std::vector<Event>& list) {
    std::string text;
    for (const Event& e : list) text += fmt::format("\n  {}{:a} +- {:.2g} use {}", e.entering ? "+" : "-", e.t, e.error, e.use);
    return text;
}

bool same(const std::vector<Event>& a, const std::vector<Event>& b, double room) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](const Event& x, const Event& y) { return x.entering == y.entering && x.use == y.use && std::abs(x.t - y.t) <= room + x.error + y.error; });
}

// Integer matrices that are a rotation, perhaps with a mirror, times a power of two or 5.
Placement exact_motion(std::mt19937_64& random) {
    const auto pick = [&](int n) { return static_cast<std::size_t>(random() % static_cast<std::uint64_t>(n)); };
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::shuffle(axes.begin(), axes.end(), random);
    const double scale = std::ldexp(1.0, static_cast<int>(pick(41)) - 20);
    Placement p;
    p.m = {};
    for (std::size_t i = 0; i < 3; ++i) p.m[4 * i + axes[i]] = (pick(2) == 0 ? 1 : -1) * scale;
    if (pick(2) == 0) {  // 3, 4, 5
        const std::size_t u = pick(3), v = (u + 1) % 3, w = (u + 2) % 3;
        Placement q;
        q.m = {};
        q.m[5 * u] = q.m[5 * v] = 3;
        q.m[4 * u + v] = -4;
        q.m[4 * v + u] = 4;
        q.m[5 * w] = 5;
        p = q * p;
    }
    for (std::size_t i = 0; i < 3; ++i) p.m[4 * i + 3] = (static_cast<double>(pick(2001)) - 1000) * scale * (pick(2) == 0 ? 0 : 1);
    return p;
}

Vec3 coarse(const Vec3& v) {
    Vec3 r;
    for (int i = 0; i < 3; ++i) r[i] = std::round(v[i] * 0x1p12) * 0x1p-12;
    return r;
}

LongMatrix turn(std::size_t axis, double deg) {
    LongMatrix m{};
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const long double a = static_cast<long double>(deg) * M_PIl / 180;
    m[axis][axis] = 1;
    m[u][u] = m[v][v] = std::cos(a);
    m[u][v] = -std::sin(a);
    m[v][u] = std::sin(a);
    return m;
}

LongMatrix product(const LongMatrix& a, const LongMatrix& b) {
    LongMatrix r{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 3; ++k) r[i][j] += a[i][k] * b[k][j];
    return r;
}

// A motion as text and as what it means, to 64 bits.
struct TextMotion {
    std::string text;
    LongMatrix linear{};
    Vec3 offset{0};
    double scale = 1;

    Vec3 of_direction(const Vec3& d) const {
        Vec3 r;
        for (std::size_t i = 0; i < 3; ++i) {
            long double sum = 0;
            for (std::size_t j = 0; j < 3; ++j) sum += linear[i][j] * d[static_cast<int>(j)];
            r[static_cast<int>(i)] = static_cast<double>(sum * scale);
        }
        return r;
    }
    Vec3 of_point(const Vec3& p) const {
        Vec3 r;
        for (std::size_t i = 0; i < 3; ++i) {
            long double sum = 0;
            for (std::size_t j = 0; j < 3; ++j) sum += linear[i][j] * p[static_cast<int>(j)];
            r[static_cast<int>(i)] = static_cast<double>(sum * scale + offset[static_cast<int>(i)]);
        }
        return r;
    }
};

// `far`: in sizes of 10, the scenes' own.
TextMotion text_motion(double scale, double far, std::mt19937_64& random) {
    std::uniform_real_distribution<double> angle(-180, 180), unit(-1, 1);
    TextMotion m;
    m.scale = scale;
    const double a = std::round(angle(random)), b = angle(random), c = angle(random);
    m.linear = product(turn(2, c), product(turn(1, b), turn(0, a)));
    for (int i = 0; i < 3; ++i) m.offset[i] = unit(random) * far * 10 * scale;
    m.text = fmt::format("translate([{}, {}, {}]) rotate([{}, {}, {}]) scale({})", literal(m.offset.x), literal(m.offset.y), literal(m.offset.z), literal(a), literal(b), literal(c),
                         literal(scale));
    return m;
}

std::uint64_t rays_asked() {
    const char* text = std::getenv("WHITTLE_RAYS");
    return text == nullptr ? 300 : std::strtoull(text, nullptr, 10);
}

Ray random_ray(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    Ray ray;
    ray.origin = 9.0 * Vec3(unit(random), unit(random), unit(random));
    ray.direction = 4.0 * Vec3(unit(random), unit(random), unit(random)) - ray.origin;
    return ray;
}

}  // namespace

TEST_CASE("a motion that doubles hold changes no event") {
    const std::uint64_t seed = fresh_seed();
    INFO("WHITTLE_SEED=" << seed);
    std::mt19937_64 random(seed);
    Scratch scratch;
    std::uint64_t met = 0, solids = 0, rays = 0, masked = 0;
    for (int i = 0; i < 200; ++i) {
        const std::uint64_t recipe = random();
        const RandomSolid solid = random_solid(Theme::kStack, recipe);
        const Placement motion = exact_motion(random);
        const Subject here = subject_of(solid.solid, true);
        const auto there = compile(random_solid(Theme::kStack, recipe, {}, motion).solid);
        if (!here.program || !there) continue;
        // Numbers that doubles do not hold once moved are another solid, which reading says.
        if (build_report(*here.program).largest_displacement > 0 || build_report(**there).largest_displacement > 0) continue;
        ++solids;
        for (int k = 0; k < 12; ++k) {
            Ray ray = support::random_ray(solid, random);
            ray.origin = coarse(ray.origin);
            ray.direction = coarse(ray.direction);
            if (ray.direction == Vec3(0)) continue;
            Ray image;
            image.origin = apply_to_point(motion, ray.origin);
            image.direction = apply_to_direction(motion, ray.direction);
            const auto a = events(*here.program, ray, scratch), b = events(**there, image, scratch);
            ++rays;
            met += a.size();
            if (same(a, b, 0)) continue;
            INFO("recipe " << recipe << "u by" << fmt::format(" {:a}", fmt::join(motion.m, " ")) << "\n ray " << to_text(ray) << "\n image " << to_text(image) << described(a)
                           << "\n and" << described(b));
            // A ray in a face takes the side of a direction that does not move with it.
            CHECK(is_masked(here, ray, 0x1p-45, 0, random));
            ++masked;
        }
    }
    INFO(masked << " of " << rays << " rays lie in faces and take another side; " << solids << " solids");
    CHECK(solids > 50);
    CHECK(met > rays / 4);
    CHECK(masked * 10 < rays);
}

TEST_CASE("scaling by a power of two changes no bit") {
    const std::uint64_t seed = fresh_seed();
    INFO("WHITTLE_SEED=" << seed);
    std::mt19937_64 random(seed);
    Scratch scratch;
    std::uint64_t met = 0;
    constexpr double kUnderflow = 0x1p-900;  // what double-double adds for numbers that underflow does not scale
    for (int i = 0; i < 20 * kThemes; ++i) {
        const std::uint64_t recipe = random();
        const Theme theme = static_cast<Theme>(i % kThemes);
        const RandomSolid solid = random_solid(theme, recipe);
        const double scale = std::ldexp(1.0, static_cast<int>(random() % 41) - 20);
        Placement motion;
        for (const std::size_t k : {0u, 5u, 10u}) motion.m[k] = scale;
        const auto here = compile(solid.solid), there = compile(random_solid(theme, recipe, {}, motion).solid);
        if (!here || !there) continue;
        INFO(support::to_code(solid.solid));
        for (int k = 0; k < 10; ++k) {
            Ray ray = support::random_ray(solid, random);
            for (int axis = 0; axis < 3; ++axis)
                if (std::abs(ray.origin[axis]) < kUnderflow) ray.origin[axis] = 0;  // numbers without all their bits lose some when scaled
            Ray image = ray;
            image.origin *= scale;
            image.direction *= scale;
            const auto a = events(**here, ray, scratch), b = events(**there, image, scratch);
            met += a.size();
            INFO(name_of(theme) << " scale " << scale << " ray " << to_text(ray));
            REQUIRE(a.size() == b.size());
            for (std::size_t n = 0; n < a.size(); ++n) {
                INFO(fmt::format("t {:a}, bounds {:a} and {:a}, use {}", a[n].t, a[n].error, b[n].error, a[n].use));
                REQUIRE(a[n].t == b[n].t);
                REQUIRE((a[n].error == b[n].error || (a[n].error < kUnderflow && b[n].error < kUnderflow)));
                REQUIRE(a[n].use == b[n].use);
                REQUIRE(a[n].entering == b[n].entering);
            }
        }
    }
    CHECK(met > 500);
}

TEST_CASE("a scene moved by its text has the same events but for rays that rounding decides") {
    const std::uint64_t seed = fresh_seed(), asked = rays_asked();
    INFO("WHITTLE_SEED=" << seed);
    std::mt19937_64 random(seed);
    Scratch scratch;
    const std::vector<std::pair<double, double>> motions{{1, 0}, {1e-6, 1}, {1e6, 1}, {1, 1e3}, {1e3, 1e5}, {0.37, 1e6}};
    std::string shares;
    for (const TextScene& scene : text_scenes()) {
        const Subject here = subject_of(solid_of(std::string(scene.definitions) + scene.text), true);
        REQUIRE(here.program);
        std::uint64_t rays = 0, masked = 0, met = 0;
        for (const auto& [scale, far] : motions) {
            const TextMotion motion = text_motion(scale, far, random);
            const auto there = compile(solid_of(std::string(scene.definitions) + motion.text + " { " + scene.text + " }"));
            REQUIRE(there);
            for (std::uint64_t i = 0; i < asked; ++i) {
                const Ray ray = random_ray(random);
                Ray image;
                image.origin = motion.of_point(ray.origin);
                image.direction = motion.of_direction(ray.direction);
                const auto a = events(*here.program, ray, scratch), b = events(**there, image, scratch);
                ++rays;
                met += a.size();
                // Half a unit in the last place of the ray, of the placement's offset and, over the size of 20, of its matrix; in the scene's own units.
                const double offset = (std::abs(motion.offset.x) + std::abs(motion.offset.y) + std::abs(motion.offset.z)) / scale;
                const double room = 0x1p-53 * (4 * offset + 20 * 8), room_of_way = 0x1p-53 * 20 * 8;
                if (same(a, b, way_of(room))) continue;  // a grazing ray's crossings move by the root of that
                INFO(scene.name << ": " << motion.text << "\n ray " << to_text(ray) << "\n image " << to_text(image) << described(a) << "\n and" << described(b));
                CHECK(is_masked(here, ray, room, room_of_way, random));
                ++masked;
            }
        }
        shares += fmt::format("\n  {}: {} of {} rays masked", scene.name, masked, rays);
        CHECK(met > rays / 4);
        CHECK(masked * 1000 < rays);
    }
    WARN("masked:" << shares);
}
