// lower_convex.cpp — a convex body known by how far it reaches: one support, cut by the planes of its flat faces.
//
// The support's own crossings keep a little outside of the flat faces (convex.h), so that there the planes are the border: exact, and shared with what abuts.
#include <cmath>

#include "csg/solid/convex_body.h"
#include "tracer/engine/formula_builder.h"

namespace whittle {

FormulaId FormulaBuilder::convex(NodeId id, const shape::ConvexBody& s, const Site& site) {
    const Bounds& box = solid_.bounds(id);
    Placer own(out_, site.chain, site.motion, box, Absorb::kNothing), upright(out_, site.chain, site.motion, box, Absorb::kAny);
    std::vector<HalfSpaceRef> sides;
    for (const FlatFace& face : s.hull->faces) {
        int axis = 3;
        for (int i = 0; i < 3; ++i)
            if (std::abs(face.n[i]) == 1) axis = i;
        if (axis < 3) sides.push_back(upright.axis_plane(axis, face.n[axis] * face.d, face.n[axis] > 0));
        else sides.push_back(own.plane(face.n, face.d));
    }
    sides.push_back(own.convex(s.hull));
    return cell(std::move(sides), own.root_box(), site);
}

}  // namespace whittle
