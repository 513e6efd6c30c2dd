// convex.h — crossings of a ray with a convex body that is known by how far it reaches (csg/solid/convex_line.h). Private to the engine.
//
// Where the body's border is a flat face that lies in a plane of its own, the crossing is put a little outside, by 2^-26 of the body's size: the body is a cell with
// these planes, and there the plane is the border. Else t is enclosed by a plane that touches the body and a triangle within it. There is no exact tier.
#pragma once

#include "tracer/engine/roots.h"

namespace whittle {

// Requires of what follows: support.kind is kConvex, and the frame is the support's.

// `leaving`: t = 0 is a crossing. False: double cannot tell.
bool convex_crossings(const Frame& frame, const FrameRay& ray, bool leaving, Crossings& out);

// Of a ray moved a little, by the rule of csg/span/perturbation.h but not without end: an answer, not a certificate.
void unsettled_convex(const Frame& frame, const Ray& ray, bool leaving, Crossings& out);

// Outward, in the frame's coordinates, at a point of the border.
Vec3 convex_gradient(const Frame& frame, const Vec3& point);

// A place of the body in the root frame.
Vec3 convex_middle(const Frame& frame);

// How far points of one body are from the other's in the root frame; infinite where the bodies have other parts.
double convex_distance(const Frame& a, const Frame& b);

}  // namespace whittle
