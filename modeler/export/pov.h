// pov.h — a scene as POV-Ray reads it, with true primitives: spheres stay spheres, set operations stay set operations.
//
// Everything the solid holds has a counterpart in POV-Ray but twisted or tapered extrusions and some turned profiles: those become meshes within the
// tolerance, which is said. Numbers have the digits that read back to the same double. Coordinates are the scene's own: the camera's vectors carry the
// handedness. Materials, lamps and the studio are translated as far as POV-Ray has the like; pictures of matte things under lamps agree.
// Source: POV-Ray 3.7 reference manual, chapters 3.4 (camera, light, objects, textures).
#pragma once

#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/eval/scene.h"
#include "csg/solid/solid.h"
#include "modeler/mesh/mesh.h"
#include "tracer/light/camera.h"

namespace whittle {

struct PovFile {
    std::string text;
    std::vector<std::string> warnings;
};

// kBounded: parts of large unions and differences stand in nested groups with bounding boxes, which POV-Ray does not make by itself inside a set operation.
enum class PovGroups { kFlat, kBounded };

// `lens` for a picture of that aspect (width / height). Errors: those of materials (kScene) and of meshes where one is needed.
Result<PovFile> pov_scene(const Solid& solid, const std::vector<Light>& lights, const Lens& lens, double aspect, const MeshOptions& mesh, PovGroups groups = PovGroups::kFlat);

}  // namespace whittle
