// convex_line.h — where a line enters and leaves a convex body that is known by its support points only, with bounds.
//
// Seen along the line the body is a convex set in the plane across it, the line a point q. Two support points and the middle make a triangle around q, or a tangent
// parts q from the set: then the line misses. From there the simplex method goes on: of the triangles of the body's points around q one whose height at q is lower
// replaces the present one, by the support point along the present one's normal, until the height of the supporting plane over q, which no point of the body is
// below, and the height of the triangle, which is in the body, are one. The error is what lies between the two, and what was rounded. That is slow where the body
// bends: after each exchange Newton's method looks for the plane that touches the parts last found farthest (one, two or three) where the line meets them, and a
// small triangle of those parts about the line closes the heights if no other part rises above that plane. Whatever it finds, the two heights decide.
//
// Source: van den Bergen, Ray Casting against General Convex Objects with Application to Continuous Collision Detection (2004); Snethen, XenoCollide (2008), whose
// portals are these triangles; Dantzig and Wolfe, Decomposition Principle for Linear Programs (1960), for the exchange.
#pragma once

#include <optional>

#include "csg/solid/convex_body.h"

namespace whittle {

struct ConvexSpan {
    enum class Kind { kMissed, kMet, kUnclear };  // kUnclear: nearer to a tangent than rounding tells
    struct Border {
        double t = 0, error = 0;
        Vec3 normal{0};        // outward, of length 1, of a plane that touches the body there
        bool certain = false;  // |t - exact t| <= error
    };
    Kind kind = Kind::kUnclear;
    Border in, out;
};

// The line o + t d. `room`: no point of the line that is meant, where it is near the body, is farther from this one.
ConvexSpan span_on_line(const ConvexHullBody& body, const Vec3& o, const Vec3& d, double room);

// The place where it leaves, alone; nothing where the line misses or is too near to a tangent.
std::optional<ConvexSpan::Border> way_out(const ConvexHullBody& body, const Vec3& o, const Vec3& d);

}  // namespace whittle
