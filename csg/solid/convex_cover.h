// convex_cover.h — a solid as a union of convex ones: what a Minkowski sum distributes over.
//
// Unions are taken apart, upright prisms and what turns about an axis are cut along their profiles' triangles, and a difference of convex sets becomes the parts of the
// first beyond each facet of the others. What is cut or bends becomes chords and flat facets within a tolerance; what is neither stays as it is.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "csg/solid/convex_body.h"
#include "csg/solid/solid.h"

namespace whittle {

struct CoverOptions {
    double tolerance = 0;      // of chords; more than 0
    std::size_t most = 0;      // pieces
    // Is the use known to be convex? (is_known_convex(), and what the caller has made)
    std::function<bool(const Use&)> is_convex;
};

struct ConvexCover {
    std::vector<Use> pieces;  // convex, of three dimensions, in the frame above the use
    bool chords = false;      // something curved became chords
};

// Nothing where there would be too many pieces, or where no cover is known: twists, tapers, lists of facets, half-spaces, motion.
std::optional<ConvexCover> convex_cover(SolidBuilder& builder, const Use& use, const CoverOptions& options);

// Points of the border of the hull of the parts: all corners, and enough of what is curved that their hull misses no point of it by more than the tolerance.
// `most`: nothing where more would be needed.
std::optional<std::vector<Vec3>> corners_within(const ConvexParts& parts, double tolerance, std::size_t most);

// The Minkowski sum of the hulls of the points: of all sums where they are few, else of those of corners that reach farthest along a facet's normal of either
// hull, which misses no more than the finer of the two misses of what it stands for. Nothing where it is flat.
std::optional<FacetList> sum_of_hulls(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace whittle
