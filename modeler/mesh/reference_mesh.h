// reference_mesh.h — the mesh of a solid by another's booleans: CGAL's corefinement over exact constructions, its Nef polyhedra where that declines,
// instead of modeler/arrange.
//
// Both take the same leaves on the same grid; from there they share no code. CGAL is slower, and refuses meshes that cross
// themselves.
#pragma once

#include "modeler/mesh/mesh.h"

namespace whittle {

// Who combines meshes.
enum class BooleanMaker { kArrangement, kCgal };

// As mesh_solid() (mesh.h). With kCgal also: kScene where CGAL declines, kWorld where its module is not installed.
Result<MeshResult> mesh_solid_by(BooleanMaker maker, const Solid& solid, const MeshOptions& options, MeshControl& control);

}  // namespace whittle
