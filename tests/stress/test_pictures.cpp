// test_pictures.cpp — what the middle of each pixel meets does not depend on where and how large the scene stands, but for rays that exact arithmetic says
// rounding decides; and the mask of tests/tracer/light/moved_test.cpp, which nudges scenes and so follows light from mirror to mirror, holds those too.
//
// WHITTLE_MOTIONS: random ones a scene (6).
#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "tests/stress/mask.h"
#include "tests/support/seed.h"
#include "tests/tracer/light/shiny_scenes.h"
#include "tracer/light/planes.h"

using namespace whittle;
using namespace whittle::stress;
using namespace whittle::test;

namespace {

constexpr int kWidth = 64;
constexpr double kReach = 40;  // from the eye to most of what it sees, at least

int motions_asked() {
    const char* text = std::getenv("WHITTLE_MOTIONS");
    return text == nullptr ? 6 : std::atoi(text);
}

Film ids_of(const ShinyScene& what, const Moved& motion, double room, std::uint64_t seed, int width_px) {
    Staged there = staged(what, motion, room, seed);
    return drawn(there.solid, std::move(there.scene), shiny_options(Integrator::kPreview, width_px)).film;
}

// The still scene's rays, one a pixel, and its exact formula.
struct Still {
    Film film;
    Subject subject;
    std::vector<Ray> rays;
};

Still still_of(const ShinyScene& what, int width_px) {
    Still still;
    Staged here = staged(what, {});
    const RenderOptions options = shiny_options(Integrator::kPreview, width_px);
    still.subject = subject_of(here.solid, true);
    REQUIRE(still.subject.program);
    here.scene.solid = &here.solid;
    const auto stage = prepare(still.subject.program, here.scene, options);
    REQUIRE(stage);
    for (int y = 0; y < options.height; ++y)
        for (int x = 0; x < options.width; ++x) still.rays.push_back(picture_ray(**stage, x + 0.5, y + 0.5));
    still.film = ids_of(what, {}, 0, 0, width_px);
    return still;
}

bool others(const Film& a, const Film& b, std::size_t pixel) { return ids_differ(a, b, Aov::kSolid, pixel) || ids_differ(a, b, Aov::kSurface, pixel); }

using Leaves = std::vector<std::uint32_t>;

Leaves first_leaves(const Subject& subject, const Ray& ray) {
    const auto borders = subject.exact->borders(ray).borders;
    return borders.empty() ? Leaves{} : borders[0].leaves;
}

}  // namespace

TEST_CASE("what the middles of pixels meet stays where the scene is moved, turned and scaled, but for rays that rounding decides") {
    const std::uint64_t seed = support::fresh_seed();
    INFO("WHITTLE_SEED=" << seed);
    std::mt19937_64 random(seed);
    std::string shares;
    for (const ShinyScene& scene : kScenes) {
        const Still still = still_of(scene, kWidth);
        std::vector<Moved> motions{{1e-6, 0, {}}, {1e6, 0, {}}, {1, 0, {1e7, -2e7, 3e7}}};
        for (int i = motions_asked(); i > 0; --i) motions.push_back(random_motion(random));
        std::size_t pixels = 0, masked = 0;
        for (const Moved& motion : motions) {
            if (motion.room() > scene.thinnest / 64) continue;  // fused in reading
            const Film there = ids_of(scene, motion, 0, 0, kWidth);
            pixels += still.rays.size();
            for (std::size_t i = 0; i < still.rays.size(); ++i) {
                if (!others(still.film, there, i)) continue;
                INFO(scene.name << fmt::format(", scale {:a}, turned by {:a}, moved by {:a} {:a} {:a}, pixel {}", motion.scale, motion.turn_deg, motion.offset.x, motion.offset.y, motion.offset.z, i));
                CHECK(is_masked(still.subject, still.rays[i], motion.room(), motion.room() / kReach, random));
                ++masked;
            }
        }
        shares += fmt::format("\n  {}: {} of {} rays masked", scene.name, masked, pixels);
        CHECK(masked * 1000 < pixels);
    }
    WARN("WHITTLE_SEED=" << seed << ", masked:" << shares);
}

// So wide a room that many rays are masked.
TEST_CASE("nudging a scene masks the pixels that exact arithmetic masks") {
    constexpr double kRoom = 0.1, kToTarget = 85;
    constexpr int kMoves = 24, kNudged = 48, kNarrow = 32;
    std::mt19937_64 random(support::fresh_seed());
    std::uniform_real_distribution<double> within(-1, 1);
    std::string shares;
    std::size_t exact_all = 0, lacking_all = 0;
    for (const ShinyScene& scene : kScenes) {
        const Still still = still_of(scene, kNarrow);
        std::set<std::size_t> exact, nudged;
        for (std::size_t i = 0; i < still.rays.size(); ++i) {
            const Leaves here = first_leaves(still.subject, still.rays[i]);
            for (int k = 0; k < kMoves && exact.count(i) == 0; ++k) {
                Ray moved = still.rays[i];
                for (int axis = 0; axis < 3; ++axis) {
                    moved.origin[axis] += within(random) * kRoom;
                    moved.direction[axis] += within(random) * kRoom / kToTarget;
                }
                if (first_leaves(still.subject, moved) != here) exact.insert(i);
            }
        }
        for (std::uint64_t k = 1; k <= kNudged; ++k) {
            const Film there = ids_of(scene, {}, kRoom, k, kNarrow);
            for (std::size_t i = 0; i < still.rays.size(); ++i)
                if (ids_differ(still.film, there, Aov::kSolid, i)) nudged.insert(i);
        }
        const auto lacking = static_cast<std::size_t>(std::count_if(exact.begin(), exact.end(), [&](std::size_t i) { return nudged.count(i) == 0; }));
        shares += fmt::format("\n  {}: {} masked exactly, {} by nudges, {} exactly but not by nudges", scene.name, exact.size(), nudged.size(), lacking);
        exact_all += exact.size();
        lacking_all += lacking;
    }
    WARN(shares);
    CHECK(exact_all > 50);
    CHECK(lacking_all * 5 <= exact_all);
}
