// scenes.h — the solids that rays are timed on, each the same on every machine: fixed seeds, numbers written here.
//
// S1 to S6 are those of the prototypes: a drilled box, a plate of counterbored holes, balls in a box less pins, a cloud of balls, a deep random
// tree, a Menger sponge. Their cameras look at the origin from a distance at which the bounding ball fills the picture.
#pragma once

#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"

namespace whittle::bench {

struct BenchScene {
    std::string name, what;
    Solid solid;
    Bounds box;              // incoherent rays go to uniform points of it
    double radius = 1.75;    // of the ball that the camera frames and incoherent rays start on
    Vec3 from{2.5, 1.8, 3.2};
    Vec3 centre{0};          // of that ball
};

// Names that make_scene() knows: S1 ... S6.
const std::vector<std::string>& scene_names();
// Requires: one of the names.
BenchScene make_scene(const std::string& name);

// The solid of a .scad file, seen from OpenSCAD's first corner; `faceted`: with OpenSCAD's facets however many they are. Fails as reading the file does.
Result<BenchScene> file_scene(const std::string& path, bool faceted);

// Balls of a scene that is nothing but their union; empty for others. For peers that have balls of their own.
struct Ball {
    Vec3 centre;
    double radius;
};
std::vector<Ball> balls_of(const std::string& name);

}  // namespace whittle::bench
