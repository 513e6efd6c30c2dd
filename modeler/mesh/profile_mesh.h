// profile_mesh.h — 2D sets as contours and triangles, for the walls and lids of extrusions and revolutions.
#pragma once

#include <functional>

#include "csg/base/result.h"
#include "csg/solid/solid.h"
#include "modeler/mesh/curve_rule.h"
#include "modeler/mesh/triangulate.h"

namespace whittle {

// Outer contours counter-clockwise, holes clockwise, indexing `points`; no two cross.
struct ProfileMesh {
    std::vector<Vec2> points;
    std::vector<std::vector<std::uint32_t>> contours;
    double error = 0;   // no point of the set's border is farther from a contour, in the root frame
    double per_mm = 1;  // grid on which the contours do not cross
};

// kScene fault for a node that is not 2D. Corners of the author's come back bit for bit; crossings of sides lie on the grid.
Result<ProfileMesh> profile_contours(const Solid& solid, NodeId node, const CurveRule& rule);

// The part with x >= 0.
ProfileMesh right_half(const ProfileMesh& profile);

// Cuts each side into parts(a, b) equal pieces.
ProfileMesh with_sides_cut(const ProfileMesh& profile, const std::function<int(const Vec2&, const Vec2&)>& parts);

// Counter-clockwise triangles on profile.points; nothing when the contours cross.
std::optional<std::vector<Triangle>> profile_triangles(const ProfileMesh& profile);

}  // namespace whittle
