// scenes.h — the solids that rays are timed on, each the same on every machine: fixed seeds, numbers written here.
//
// S1 to S6 are those of the prototypes: a drilled box, a plate of counterbored holes, balls in a box less pins, a cloud of balls, a deep random
// tree, a Menger sponge. Their cameras look at the origin from a distance at which the bounding ball fills the picture. Families go on from there by
// a number in the name: menger2 ... menger5, plate25 ... plate10000 (holes), balls100 ... balls1000000, instances1000000 (of S1's part), mesh1000000 (triangles).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"

namespace whittle::bench {

struct Ball {
    Vec3 centre;
    double radius;
};

struct BenchScene {
    std::string name, what;
    Solid solid;
    Bounds box;              // incoherent rays go to uniform points of it
    double radius = 1.75;    // of the ball that the camera frames and incoherent rays start on
    Vec3 from{2.5, 1.8, 3.2};
    Vec3 centre{0};          // of that ball
    double primitives = 1;   // uses of shapes; triangles of a mesh
    // The same solid for peers with such things of their own; empty where it is none.
    std::vector<Ball> balls;
    std::shared_ptr<const FacetList> facets;
    int sponge_level = 0;
    std::shared_ptr<const BenchScene> part;  // all placements of it are the solid
    std::vector<Placement> placements;
    bool meshable = false;   // by the modeler, in reasonable time
};

// One ball of radius 1.
BenchScene ball_scene();
// Does make_scene() know the name?
bool is_scene(const std::string& name);
// Nothing for a name that stands for no scene.
std::optional<BenchScene> make_scene(const std::string& name);

// The solid of a .scad file, seen from OpenSCAD's first corner; `faceted`: with OpenSCAD's facets however many they are. Fails as reading the file does.
Result<BenchScene> file_scene(const std::string& path, bool faceted);

}  // namespace whittle::bench
