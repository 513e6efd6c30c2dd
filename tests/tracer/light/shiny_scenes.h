// shiny_scenes.h — scenes of mirrors and glass that tests move, turn, scale and nudge.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include "csg/base/degrees.h"
#include "tests/tracer/light/scenes.h"

namespace whittle::test {

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

inline Placement at(Nudges& nudge, double x, double y, double z) { return Placement::translation(Vec3(x, y, z) + nudge()); }

inline Placement turned(Nudges& nudge, double deg, double x, double y, double z) {
    Placement p = at(nudge, x, y, z);
    const double c = cosd(deg), s = sind(deg);
    p.m[0] = p.m[5] = c;
    p.m[1] = -s;
    p.m[4] = s;
    return p;
}

inline void add_floor(SceneBuilder& b, Nudges& nudge) {
    Use floor = b.box(Vec3(-40, -40, -12), Vec3(40, 40, -10), matte(1, 0.75, 0.5));
    floor.placement = at(nudge, 0, 0, 0);
    b.add(floor);
}

// A mirroring ball, a lens, a shell of glass whose wall is 1e-9 of its size.
inline void fill_shell(SceneBuilder& b, Nudges& nudge) {
    add_floor(b, nudge);
    b.add(b.ball(8, preset("mirror"), at(nudge, -14, 6, -1)));
    b.add(b.ball(5, preset("glass"), at(nudge, 10, -12, -4)));
    Use shell = b.combined(SetOp::kDifference, {b.ball(9, preset("glass")), b.ball(9 * (1 - 1e-9), preset("glass"))});
    shell.placement = at(nudge, 12, 8, 0);
    b.add(shell);
}

// Two mirrors face to face, balls and a ring of mirror between them: images of images.
inline void fill_hall(SceneBuilder& b, Nudges& nudge) {
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
inline void fill_glass(SceneBuilder& b, Nudges& nudge) {
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
inline void fill_drink(SceneBuilder& b, Nudges& nudge) {
    add_floor(b, nudge);
    Use cup = b.combined(SetOp::kDifference, {b.rod(-9, 9, 9, preset("glass")), b.rod(-7, 10, 8)});
    Use drink = b.combined(SetOp::kUnion, {cup, b.rod(-7, 5, 8, preset("water")), b.ball(3, preset("mirror"), moved(2, -1, -3))});
    drink.placement = at(nudge, -5, -4, 0);
    b.add(drink);
    b.add(b.ball(6, preset("mirror"), at(nudge, 13, 5, -3)));
}

// Four mirroring balls close together: light between them is chaotic.
inline void fill_balls(SceneBuilder& b, Nudges& nudge) {
    add_floor(b, nudge);
    for (const Vec3& p : {Vec3(-8, -5, -2), Vec3(8, -5, -2), Vec3(0, 8, -2), Vec3(0, -0.5, 11)}) b.add(b.ball(7.5, preset("mirror"), at(nudge, p.x, p.y, p.z)));
}

inline const std::array<ShinyScene, 5> kScenes{{{"shell", fill_shell, 9e-9}, {"hall", fill_hall, 1}, {"glass", fill_glass, 1}, {"drink", fill_drink, 1}, {"balls", fill_balls, 1}}};

// scale * turn * p + offset.
struct Moved {
    double scale = 1;
    double turn_deg = 0;  // about z, then as much about x
    Vec3 offset{0};
    bool exact = false;  // doubles hold all numbers of the moved scene

    Placement placement() const {
        const double c = cosd(turn_deg), s = sind(turn_deg);
        Placement p;
        p.m = {scale * c, -scale * s, 0, offset.x, scale * c * s, scale * c * c, -scale * s, offset.y, scale * s * s, scale * s * c, scale * c, offset.z};
        return p;
    }
    // What coordinates are rounded by, in units of the unmoved scene, whose reach is 100.
    double room() const { return 0x1p-53 * (8 * 100 + 4 * (std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z)) / scale); }
};

// The scene as a solid, with its lamp and camera, where the motion takes it; all but the surroundings nudged. Their grey lies between no two bytes, as 0.5 does.
struct Staged {
    Solid solid;
    RenderScene scene;
};

inline Staged staged(const ShinyScene& what, const Moved& motion, double room = 0, std::uint64_t seed = 0) {
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
    scene.lights = {lamp(p), around(Vec3(0.45))};
    return {b.finish(placement), std::move(scene)};
}

// With the leaf and the surface that the middle of each pixel meets.
inline RenderOptions shiny_options(Integrator integrator, int width_px) {
    RenderOptions options = small_options();
    options.integrator = integrator;
    options.width = width_px;
    options.height = width_px * 3 / 4;
    options.aovs = aov_bit(Aov::kSolid) | aov_bit(Aov::kSurface);
    return options;
}

// Scales from 1e-6 to 1e6, moves of up to 1e5 sizes of 40, half of them turned.
inline Moved random_motion(std::mt19937_64& random) {
    std::uniform_real_distribution<double> six(-6, 6), unit(-1, 1), angle(-180, 180);
    Moved motion;
    motion.scale = std::pow(10, six(random));
    const double far = 40 * motion.scale * std::pow(10, 5.0 / 6 * std::abs(six(random)));
    motion.offset = far * Vec3(unit(random), unit(random), unit(random));
    if (random() % 2 == 0) motion.turn_deg = angle(random);
    return motion;
}

inline bool ids_differ(const Film& a, const Film& b, Aov ids, std::size_t pixel) {
    return a.planes[static_cast<std::size_t>(ids)][pixel] != b.planes[static_cast<std::size_t>(ids)][pixel];
}

}  // namespace whittle::test
