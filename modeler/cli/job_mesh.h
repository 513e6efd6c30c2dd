// job_mesh.h — meshing, for the verbs `mesh` and `check` and for OpenSCAD's form.
#pragma once

#include "modeler/cli/session.h"
#include "modeler/mesh/mesh_files.h"

namespace whittle {

// mesh_solid() with the request's options: progress shown, timed and counted.
Result<MeshResult> make_mesh(Session& session, const Solid& solid);

// One mesh into all of `paths`; `ascii`: .stl in letters.
Exit mesh_outputs(Session& session, const std::vector<std::string>& paths, bool ascii);

}  // namespace whittle
