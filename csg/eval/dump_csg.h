// dump_csg.h — a scene as a .csg file: OpenSCAD's flat form, in which every loop and module has been run.
#pragma once

#include <string>

#include "csg/eval/scene.h"

namespace whittle {

// For scenes of plain OpenSCAD the text is OpenSCAD's, character for character.
std::string dump_csg(const Scene& scene);

}  // namespace whittle
