// cone.h — a thin cone of rays about a ray: does an edge of the solid cross it, and where?
//
// A cone's section at a distance is a disc. Near the axis each half-space covers of it what a straight edge leaves, so the edge that passes nearest to the
// axis divides the disc in two parts: one ray through the middle of each, weighed by the areas, then stands for the whole cone. Edges are where a face
// ends at another half-space of the formula, or bends away from the ray (the silhouette of a quadric or torus). A single edge a cone is told; where two
// edges cross it the nearer to the axis is. Cones through extruded polygons, meshes or what moves are not divided.
// Source: Amanatides, Ray Tracing with Cones (1984).
#pragma once

#include "tracer/engine/engine.h"

namespace whittle {

// Radius of the section at t: start + spread * t. The direction is a unit vector.
struct Cone {
    Ray axis;
    double start = 0, spread = 0;
};

// `share` of the section lies on the axis's side of the edge; `here` and `there` are the middles of the two parts as offsets from the axis, to be
// multiplied by the radius. Undivided: share 1, both zero.
struct ConeSplit {
    double share = 1;
    double t = 0;  // of the edge
    Vec3 here{0}, there{0};
    bool divided() const { return share < 1; }
};

// `t_hit`: where the axis meets the solid, infinite where it does not. Edges behind it do not count. Surfaces that the axis departs from do not either.
ConeSplit split_cone(const Program& program, const Cone& cone, double t_hit);

// Of a disc of radius 1 cut at the distance `offset` in [0, 1] from its middle: the share of the smaller part, and how far its centroid lies out.
struct DiscCut {
    double share = 0, centroid = 0;
};
DiscCut cut_disc(double offset);

}  // namespace whittle
