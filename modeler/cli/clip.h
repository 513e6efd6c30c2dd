// clip.h — --clip: the scene cut by half-spaces before it becomes a solid, so that cuts are as solid and as exact as any other.
#pragma once

#include <array>
#include <vector>

#include "csg/eval/scene.h"

namespace whittle {

// Keeps the points with n.p <= d of every clip (nx, ny, nz, d). The cut faces have the colour of what is cut.
void clip_scene(Scene& scene, const std::vector<std::array<double, 4>>& clips);

}  // namespace whittle
