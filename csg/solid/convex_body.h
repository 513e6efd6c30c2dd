// convex_body.h — convex bodies by how far they reach: hulls and sums of cylinders, cones, balls, ellipsoids, rings, corners, wherever they stand.
//
// A part is the Minkowski sum of a point and of linear images of the unit ball: a corner, a disc, an ellipsoid, the hull of a ring (disc and ball). A body is the
// hull of its parts. In a direction n a part reaches n.c + |M^T n| + ..., the body as far as the part that reaches farthest; the hull of bodies has all their
// parts, their sum the sums of any two.
// Source: Schneider, Convex Bodies: The Brunn-Minkowski Theory (1993), 1.7 support functions.
#pragma once

#include <optional>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle {

using ConvexParts = std::vector<ConvexPart>;

// How far the part reaches along n (of any length), and a point of it that does.
double reach(const ConvexPart& part, const Vec3& n);
Vec3 farthest_point(const ConvexPart& part, const Vec3& n);

// The direction's components along the image's columns.
inline Vec3 components(const BallImage& image, const Vec3& n) { return {glm::dot(n, image.u), glm::dot(n, image.v), glm::dot(n, image.w)}; }

// The same of the hull of some parts, not none; the first of those that reach farthest.
const ConvexPart& farthest_part(const ConvexParts& parts, const Vec3& n);
double reach(const ConvexParts& parts, const Vec3& n);
Vec3 farthest_point(const ConvexParts& parts, const Vec3& n);

// A point of the inside, and no point of the hull is farther from it than the size.
Vec3 middle_of(const ConvexParts& parts);
double size_of(const ConvexParts& parts, const Vec3& middle);

// Parts whose hull is the hull of the use, rounded once; nothing where there are none such: below intersections and differences, for parabolas, twists, parts of
// revolutions, in motion.
std::optional<ConvexParts> convex_parts_of(const Solid& solid, const Use& use);

// The sums of one part of each.
ConvexParts sums_of(const ConvexParts& a, const ConvexParts& b);

// Without parts that are met twice and corners inside the hull of all corners.
ConvexParts without_hidden_parts(ConvexParts parts);

// A plane n.p = d, n of length 1, in which the body has a face that is no line and no point; and a place in that face.
struct FlatFace { Vec3 n; double d; Vec3 middle; };

// Those in which a disc lies, three centres or more, or that stand across an axis: not those of a plane that happens to touch three parts elsewhere.
std::vector<FlatFace> flat_faces(const ConvexParts& parts);

// A point of the face that reaches farthest along `way`, a direction across the face's normal. `size`: as of size_of().
Vec3 farthest_point(const ConvexParts& parts, double size, const FlatFace& face, const Vec3& way);

// The hull of parts, and what who asks it often needs to know of it.
class ConvexHullBody {
public:
    explicit ConvexHullBody(ConvexParts parts);
    const ConvexParts parts;
    const Vec3 middle;
    const double size;
    const std::vector<FlatFace> faces;
};

}  // namespace whittle
