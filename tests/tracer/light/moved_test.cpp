// Pictures of scenes full of mirrors and glass, moved, turned and scaled: what they show and its colours stay, but for pixels that rounding decides.
//
// Which those are is computed here: the unmoved scene is drawn several times with its eye, its lamp and each of its objects moved by what the motion may round
// coordinates by. So every ray of the tree of mirrors and refractions, and every ray from the lamps, meets the next object a little elsewhere. A pixel that
// changes then is masked; of all others none may differ.
//
// WHITTLE_WIDTH: of the pictures in pixels (64).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include <fmt/format.h>

#include "csg/base/degrees.h"
#include "scenes.h"
#include "tracer/image/tone.h"

using namespace whittle;
using namespace whittle::test;

namespace {

constexpr double kLimit = 1e-6;
constexpr std::uint64_t kNudges = 6;       // of every pixel
constexpr std::uint64_t kMostNudges = 200;  // of those that differ all the same

// Numbers within `room` of 0.
class Nudges {
public:
    Nudges(double room, std::uint64_t seed) : room_(room), random_(seed) {}
    Vec3 operator()() {
        std::uniform_real_distribution<double> within(-room_, room_);
        return room_ > 0 ? Vec3(within(random_), within(random_), within(random_)) : Vec3(0);
    }

private:
    double room_;
    std::mt19937_64 random_;
};

// Some 40 mm across, about the origin, above a floor at -10.
struct ShinyScene {
    const char* name;
    void (*fill)(SceneBuilder& b, Nudges& nudge);
    double thinnest;  // wall
};

Placement at(Nudges& nudge, double x, double y, double z) { return Placement::translation(Vec3(x, y, z) + nudge()); }

Placement turned(Nudges& nudge, double deg, double x, double y, double z) {
    Placement p = at(nudge, x, y, z);
    const double c = cosd(deg), s = sind(deg);
    p.m[0] = p.m[5] = c;
    p.m[1] = -s;
    p.m[4] = s;
    return p;
}

void add_floor(SceneBuilder& b, Nudges& nudge) {
    Use floor = b.box(Vec3(-40, -40, -12), Vec3(40, 40, -10), matte(1, 0.75, 0.5));
    floor.placement = at(nudge, 0, 0, 0);
    b.add(floor);
}

// A mirroring ball, a lens, a shell of glass whose wall is 1e-9 of its size.
void fill_shell(SceneBuilder& b, Nudges& nudge) {
    add_floor(b, nudge);
    b.add(b.ball(8, preset("mirror"), at(nudge, -14, 6, -1)));
    b.add(b.ball(5, preset("glass"), at(nudge, 10, -12, -4)));
    Use shell = b.combined(SetOp::kDifference, {b.ball(9, preset("glass")), b.ball(9 * (1 - 1e-9), preset("glass"))});
    shell.placement = at(nudge, 12, 8, 0);
    b.add(shell);
}

// Two mirrors face to face, balls and a ring of mirror between them: images of images.
void fill_hall(SceneBuilder& b, Nudges& nudge) {
    add_floor(b, nudge);
    for (const double y : {-12.0, 14.0}) {
        Use wall = b.box(Vec3(-18, -0.5, -10), Vec3(18, 0.5, 8), preset("mirror"));
        if (y < 0) wall = b.box(Vec3(-18, -0.5, -10), Vec3(18, 0.5, -4), preset("mirror"));
        wall.placement = turned(nudge, y / 4, 0, y, 0);
        b.add(wall);
    }
    Use ring = b.use(b.shapes().shape(shape::Torus{6, 2}), preset("mirror"));
    ring.placement = at(nudge, -6, 2, -4);
    b.add(ring);
    b.add(b.ball(4, preset("mirror"), at(nudge, 9, -2, -5)));
    b.add(b.ball(2.5, matte(0.2, 0.5, 0.9), at(nudge, 1, 6, 3)));
}

// Cut glass: a lens of two balls, a bored ball, a block turned, a cone; a mirror behind.
void fill_glass(SceneBuilder& b, Nudges& nudge) {
    add_floor(b, nudge);
    Use lens = b.combined(SetOp::kIntersection, {b.ball(10, preset("glass"), moved(0, -7, 0)), b.ball(10, preset("glass"), moved(0, 7, 0))});
    lens.placement = turned(nudge, 20, -12, -8, -2);
    b.add(lens);
    Use bored = b.combined(SetOp::kDifference, {b.ball(7, preset("glass")), b.rod(-9, 9, 3)});
    bored.placement = at(nudge, 10, -6, -3);
    b.add(bored);
    Use block = b.box(Vec3(-3, -5, -4), Vec3(3, 5, 6), preset("water"));
    block.placement = turned(nudge, 33, -4, 10, -5);
    b.add(block);
    Use cone = b.use(b.shapes().shape(shape::Frustum{-6, 6, 5, 1}), preset("glass"));
    cone.placement = at(nudge, 14, 10, -3.5);
    b.add(cone);
    Use back = b.box(Vec3(-20, 0, -10), Vec3(20, 1, 12), preset("mirror"));
    back.placement = turned(nudge, -8, 0, 20, 0);
    b.add(back);
}

// A glass of water with a ball in it, in front of a mirror: clear matters that touch.
void fill_drink(SceneBuilder& b, Nudges& nudge) {
    add_floor(b, nudge);
    Use cup = b.combined(SetOp::kDifference, {b.rod(-9, 9, 9, preset("glass")), b.rod(-7, 10, 8)});
    Use drink = b.combined(SetOp::kUnion, {cup, b.rod(-7, 5, 8, preset("water")), b.ball(3, preset("mirror"), moved(2, -1, -3))});
    drink.placement = at(nudge, -5, -4, 0);
    b.add(drink);
    b.add(b.ball(6, preset("mirror"), at(nudge, 13, 5, -3)));
}

// Four mirroring balls close together: light between them is chaotic.
void fill_balls(SceneBuilder& b, Nudges& nudge) {
    add_floor(b, nudge);
    for (const Vec3& p : {Vec3(-8, -5, -2), Vec3(8, -5, -2), Vec3(0, 8, -2), Vec3(0, -0.5, 11)}) b.add(b.ball(7.5, preset("mirror"), at(nudge, p.x, p.y, p.z)));
}

const std::array<ShinyScene, 5> kScenes{{{"shell", fill_shell, 9e-9}, {"hall", fill_hall, 1}, {"glass", fill_glass, 1}, {"drink", fill_drink, 1}, {"balls", fill_balls, 1}}};

// scale * turn * p + offset.
struct Moved {
    double scale = 1;
    double turn_deg = 0;  // about z, then as much about x
    Vec3 offset{0};
    bool exact = false;      // doubles hold all numbers of the moved scene

    Placement placement() const {
        const double c = cosd(turn_deg), s = sind(turn_deg);
        Placement p;
        p.m = {scale * c, -scale * s, 0, offset.x, scale * c * s, scale * c * c, -scale * s, offset.y, scale * s * s, scale * s * c, scale * c, offset.z};
        return p;
    }
    // What coordinates are rounded by, in units of the unmoved scene, whose reach is 100.
    double room() const { return 0x1p-53 * (8 * 100 + 4 * (std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z)) / scale); }
};

int width_asked() {
    const char* text = std::getenv("WHITTLE_WIDTH");
    return text == nullptr ? 64 : std::atoi(text);
}

Film picture(const ShinyScene& what, Integrator integrator, const Moved& motion, double room, std::uint64_t seed) {
    Nudges nudge(room, seed);
    SceneBuilder b;
    what.fill(b, nudge);
    const Placement placement = motion.placement();
    PointLight p;
    p.p = apply_to_point(placement, Vec3(25, -20, 50) + nudge());
    p.power = 1e5 * motion.scale * motion.scale;
    RenderScene scene;
    scene.camera = looking(apply_to_point(placement, Vec3(5, -75, 35) + nudge()), apply_to_point(placement, Vec3(0, 0, -2) + nudge()), 30);
    scene.camera->up = apply_to_direction(placement, Vec3(0, 0, 1)) / motion.scale;
    scene.lights = {lamp(p), around(Vec3(0.5))};
    RenderOptions options = small_options();
    options.integrator = integrator;
    options.width = width_asked();
    options.height = options.width * 3 / 4;
    options.aovs = aov_bit(Aov::kSolid) | aov_bit(Aov::kSurface);
    return drawn(b.finish(placement), scene, options).film;
}

bool differ(const Film& a, const Film& b, Aov ids, std::size_t pixel) {
    return a.planes[static_cast<std::size_t>(ids)][pixel] != b.planes[static_cast<std::size_t>(ids)][pixel];
}

// Other matter or colour?
bool differ(const Film& a, const Film& b, std::size_t pixel, double limit = kLimit) {
    return differ(a, b, Aov::kSolid, pixel) || glm::length(a.color(pixel) - b.color(pixel)) > limit * (1 + glm::length(a.color(pixel)));
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
        const bool other = differ(still, there, i) || differ(still, there, Aov::kSurface, i);
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
    if (motion.exact) CHECK(bytes_of(there) == bytes_of(still));
}

}  // namespace

TEST_CASE("pictures of mirrors and glass stay where the scene is moved, turned and scaled, but for pixels that rounding decides") {
    const std::vector<Moved> motions{{7.3, 0, {}}, {1e-6, 0, {1e-4, 2e-4, 3e-5}}, {1e6, 0, {-3e8, 1e8, 2e8}}, {1, 0, {128, -256, 64}, true}, {0.37, 0, {1e4, -3e4, 2e4}}, {1, 0, {1e7, -2e7, 3e7}},
                                     {1, 90, {}, true}, {1, 37, {}}, {1e3, -111, {1e6, 3e6, -2e6}}};
    std::string shares;
    for (const ShinyScene& scene : kScenes) {
        Share share;
        for (const Integrator integrator : {Integrator::kWhitted, Integrator::kCaustics}) {
            const Film still = picture(scene, integrator, {}, 0, 0);
            for (const Moved& motion : motions) {
                // The lamps of a turned scene send other rays, at random. A wall that is no thicker than what its placement rounds is fused in reading.
                if ((motion.turn_deg != 0 && integrator != Integrator::kWhitted) || motion.room() > scene.thinnest / 64) continue;
                compare(scene, integrator, still, motion, share);
            }
        }
        shares += fmt::format("\n  {}: {} of {} pixels masked, {} differ", scene.name, share.masked, share.pixels, share.differing);
        CHECK(share.masked * 1000 < share.pixels);
    }
    WARN("masked:" << shares);
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
