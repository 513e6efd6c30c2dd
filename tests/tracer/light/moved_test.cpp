// Pictures of scenes full of mirrors and glass, moved, turned and scaled: what they show and its colours stay, but for pixels that rounding decides.
//
// Which those are is computed here: the unmoved scene is drawn several times with its eye, its lamp and each of its objects moved by what the motion may round
// coordinates by. So every ray of the tree of mirrors and refractions, and every ray from the lamps, meets the next object a little elsewhere. A pixel that
// changes then is masked; of all others none may differ. tests/stress/test_pictures.cpp holds the ids to a mask in 200 bits, and this mask to that one.
//
// WHITTLE_WIDTH: of the pictures in pixels (64). WHITTLE_MOTIONS: random ones a scene and integrator (2).
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tests/support/seed.h"
#include "tests/tracer/light/shiny_scenes.h"
#include "tracer/image/tone.h"

using namespace whittle;
using namespace whittle::test;

namespace {

constexpr double kLimit = 1e-6;
constexpr std::uint64_t kNudges = 6;       // of every pixel
constexpr std::uint64_t kMostNudges = 200;  // of those that differ all the same

int asked(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::atoi(text);
}

Film picture(const ShinyScene& what, Integrator integrator, const Moved& motion, double room, std::uint64_t seed) {
    Staged there = staged(what, motion, room, seed);
    return drawn(there.solid, std::move(there.scene), shiny_options(integrator, asked("WHITTLE_WIDTH", 64))).film;
}

// Other matter or colour?
bool differ(const Film& a, const Film& b, std::size_t pixel, double limit = kLimit) {
    return ids_differ(a, b, Aov::kSolid, pixel) || glm::length(a.color(pixel) - b.color(pixel)) > limit * (1 + glm::length(a.color(pixel)));
}

std::vector<std::uint8_t> bytes_of(const Film& film) {
    std::vector<std::uint8_t> bytes;
    const ToneCurve curve{Tone{}};
    for (std::size_t i = 0; i < film.pixels.size(); ++i) curve.append(film.color(i), bytes);
    return bytes;
}

std::vector<bool> mask_of(const ShinyScene& what, Integrator integrator, const Film& still, double room) {
    std::vector<bool> mask(still.pixels.size());
    for (std::uint64_t seed = 1; seed <= kNudges; ++seed) {
        const Film nudged = picture(what, integrator, {}, room, seed);
        for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = mask[i] || differ(still, nudged, i);
    }
    return mask;
}

// Of a scene's pictures under several motions.
struct Share {
    std::size_t pixels = 0, masked = 0, differing = 0;
};

// How many of these pixels no nudge changes.
std::size_t unexplained(const ShinyScene& what, Integrator integrator, const Film& still, double room, std::vector<std::size_t> pixels) {
    for (std::uint64_t seed = kNudges + 1; seed <= kMostNudges && !pixels.empty(); ++seed) {
        const Film nudged = picture(what, integrator, {}, room, seed);
        pixels.erase(std::remove_if(pixels.begin(), pixels.end(), [&](std::size_t i) { return differ(still, nudged, i); }), pixels.end());
    }
    return pixels.size();
}

void compare(const ShinyScene& what, Integrator integrator, const Film& still, const Moved& motion, Share& share) {
    const Film there = picture(what, integrator, motion, 0, 0);
    const std::vector<bool> mask = mask_of(what, integrator, still, motion.room());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        const bool other = differ(still, there, i) || ids_differ(still, there, Aov::kSurface, i);
        share.masked += mask[i];
        share.differing += other;
        if (other && !mask[i]) open.push_back(i);
    }
    share.pixels += mask.size();
    const std::size_t beyond = unexplained(what, integrator, still, motion.room(), open);
    share.masked += open.size() - beyond;
    INFO(what.name << ", " << integrator_name(integrator) << ", scale " << motion.scale << ", turned by " << motion.turn_deg << ", moved by " << motion.offset.x << " " << motion.offset.y << " "
                   << motion.offset.z);
    CHECK(beyond == 0);
    const bool same_bytes = bytes_of(there) == bytes_of(still);
    if (motion.exact) CHECK(same_bytes);
}

// The lamps of a turned scene send other rays, at random. Cones look into boxes along the axes for what they may meet, and what is turned fills others. A wall
// that is no thicker than what its placement rounds is fused in reading.
bool is_left_out(const ShinyScene& scene, Integrator integrator, const Moved& motion) {
    const bool quarter = std::fmod(motion.turn_deg, 90) == 0;
    if (motion.turn_deg != 0 && (integrator == Integrator::kCaustics || (integrator == Integrator::kCone && !quarter))) return true;
    return motion.room() > scene.thinnest / 64;
}

}  // namespace

TEST_CASE("pictures of mirrors and glass stay where the scene is moved, turned and scaled, but for pixels that rounding decides") {
    const std::uint64_t seed = support::fresh_seed();
    INFO("WHITTLE_SEED=" << seed);
    std::mt19937_64 random(seed);
    const std::vector<Moved> fixed{{7.3, 0, {}}, {1e-6, 0, {1e-4, 2e-4, 3e-5}}, {1e6, 0, {-3e8, 1e8, 2e8}}, {1, 0, {128, -256, 64}, true}, {0.37, 0, {1e4, -3e4, 2e4}}, {1, 0, {1e7, -2e7, 3e7}},
                                   {1, 90, {}, true}, {1, 37, {}}, {1e3, -111, {1e6, 3e6, -2e6}}};
    std::string shares;
    for (const ShinyScene& scene : kScenes) {
        Share share;
        for (const Integrator integrator : {Integrator::kWhitted, Integrator::kCone, Integrator::kCaustics}) {
            const Film still = picture(scene, integrator, {}, 0, 0);
            std::vector<Moved> motions = fixed;
            for (int i = asked("WHITTLE_MOTIONS", 2); i > 0; --i) motions.push_back(random_motion(random));
            for (const Moved& motion : motions)
                if (!is_left_out(scene, integrator, motion)) compare(scene, integrator, still, motion, share);
        }
        shares += fmt::format("\n  {}: {} of {} pixels masked, {} differ", scene.name, share.masked, share.pixels, share.differing);
        CHECK(share.masked * 1000 < share.pixels);
    }
    WARN("WHITTLE_SEED=" << seed << ", masked:" << shares);
}

// What a mirror shows moves where what the ray met first does not: a nudge must change such pixels, else the mask ends at the first hit.
TEST_CASE("the mask of moved pictures follows rays from mirror to mirror") {
    const ShinyScene& hall = kScenes[1];
    const Film still = picture(hall, Integrator::kWhitted, {}, 0, 0), nudged = picture(hall, Integrator::kWhitted, {}, 0.5, 1);
    std::size_t seen_again = 0;
    for (std::size_t i = 0; i < still.pixels.size(); ++i) seen_again += !differ(still, nudged, i, HUGE_VAL) && differ(still, nudged, i, 0.05);
    CHECK(seen_again > 10);
    const std::vector<bool> none = mask_of(hall, Integrator::kWhitted, still, 0);
    CHECK(std::find(none.begin(), none.end(), true) == none.end());
}
