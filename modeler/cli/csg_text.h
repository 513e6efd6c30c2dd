// csg_text.h — `-o x.csg`: the evaluated scene as text that is itself a scene, in the form OpenSCAD dumps it.
#pragma once

#include <string>

#include "csg/eval/scene.h"

namespace whittle {

// Transforms become multmatrix, loops and user modules groups. Numbers have as many digits as read back to the same double.
// Law: reading the text gives the same solid.
std::string csg_text(const Scene& scene);

}  // namespace whittle
