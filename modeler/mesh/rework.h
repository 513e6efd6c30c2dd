// rework.h — a finished mesh with other triangles: fewer ones, or ones of a size. What comes back is as valid as what went in, and how far it strays from
// it is a bound that was shown (deviation.h), not what the library that did it was asked for.
#pragma once

#include "modeler/mesh/mesh.h"

namespace whittle {

struct Reworked {
    MeshResult result;     // tolerance_mm includes the deviation
    double deviation = 0;  // no point of either surface is farther from the other
    bool changed = true;   // false: nothing that holds the promise was found, the mesh is as it was
};

// Fewer triangles by OpenMesh, the Hausdorff distance from `in` at most `most_mm`; so are borders between colours and parts.
// Errors: kWorld where the module is not installed; kInterrupted.
Result<Reworked> simplified(const MeshResult& in, double most_mm, MeshControl& control);

// Triangles of about `edge_mm` a side by CGAL; edges that turn by more than 30 degrees and borders between colours and
// parts stay where they are, divided where they are longer; a triangle's leaf is then the first of its colour and part.
// Where that would make triangles cross, from a mesh simplified by a 64th or a 16th of it.
// Errors: kWorld where the module is not installed or triangles of that size are too many; kScene where the surface cannot be remeshed so; kInterrupted.
Result<Reworked> remeshed(const MeshResult& in, double edge_mm, MeshControl& control);

}  // namespace whittle
