// faults.h — faults planted in a right mesh: where and how comes from the dice, and each moves, adds or takes something by at least `size`.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "modeler/mesh/mesh.h"

namespace whittle::test {

// The solid they are planted in: a box of edge 8 about the origin with a tilted bore of radius 1 and a ball of radius 3 on top. `tolerance` as in MeshOptions.
struct Subject {
    Solid solid;
    MeshResult made;
};
struct SubjectChanges {
    double ball = 3, bore = 1;
    bool has_bore = true, has_ball = true, swapped = false;
    Vec3 ball_at{0, 0, 5};
};
Subject subject(double tolerance_mm, const SubjectChanges& changes = {});

using PlantFault = std::function<Mesh(const Subject&, double size, std::mt19937_64& random)>;
struct NamedFault {
    const char* name;
    PlantFault plant;
};
const std::vector<NamedFault>& faults();

}  // namespace whittle::test
