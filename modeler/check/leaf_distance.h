// leaf_distance.h — how far a point is from the boundary of the nearest leaf of a solid, curved and flat parts apart.
//
// A tessellation may differ from its solid near curved faces, by its tolerance; near flat faces by rounding only. So both distances are asked for.
// Distances are exact for leaves under rigid motions and uniform scale; elsewhere (sheared or stretched placements, tapered or twisted extrusions,
// quadrics) they are of first order: value over gradient, exact in the limit near the surface, which is where they are compared with a tolerance.
// Shares no code with tracer/engine or modeler/mesh: it stands between the two.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"

namespace whittle {

inline constexpr double kInfiniteDistance = std::numeric_limits<double>::infinity();

struct LeafDistance {
    double curved = kInfiniteDistance;
    double flat = kInfiniteDistance;
};

// A leaf in the root frame that is not made of facets. Extrusions and revolutions are one leaf for each shape of their profile.
struct PlacedLeaf {
    Shape shape;
    Placement placement, inverse;
    bool exact = true;  // false: the distance in the leaf's own frame is of first order
    double scale = 0;   // of lengths, where that is exact and the placement keeps shapes; else 0
    Bounds bounds;     // in the root frame
    SourcePlace place;
    double steepest = kInfiniteDistance;  // no distance is smaller than the value in the leaf's own frame over this
    // Shape of the profile, where `shape` is an Extrusion or a Revolution that cannot be told in simpler shapes.
    Shape profile = shape::Disc{0};
    Placement profile_inverse;
    double profile_scale = 1;  // of lengths, from the profile's frame, where that is exact
    Bounds profile_bounds;  // of the whole profile, in the profile's frame: where the cut faces of a revolution lie
};

class PlacedFacets;

class LeafDistances {
public:
    // Fails with kScene where an extrusion in slices cannot be cut into facets.
    static Result<LeafDistances> of(const Solid& solid);
    LeafDistances(LeafDistances&&) noexcept;
    LeafDistances& operator=(LeafDistances&&) noexcept;
    ~LeafDistances();

    struct Nearest {
        double ratio = std::numeric_limits<double>::infinity();  // min(curved / curved_bound, flat / flat_bound)
        double distance = std::numeric_limits<double>::infinity();
        double bound = 0;
        SourcePlace place;
    };
    // The leaf whose boundary is nearest to p, measured in bounds. Leaves farther than `reach` times the greater bound need not be seen, and where a
    // curved leaf explains p (ratio <= 1) flat ones need not either: the ratio may then be too large, never on the wrong side of 1.
    Nearest nearest(Vec3 p, double curved_bound, double flat_bound, double reach) const;

    bool any_curved() const { return curved_ > 0; }
    std::size_t size() const { return leaves_.size(); }

private:
    LeafDistances();
    struct Grid;
    std::vector<PlacedLeaf> leaves_;
    std::unique_ptr<Grid> grid_;
    std::unique_ptr<PlacedFacets> facets_;  // shapes of facets are not among the leaves
    std::size_t curved_ = 0;  // the first so many leaves have curved faces
};

// Of one leaf's boundary, from a point of the root frame; a distance known to exceed `most` may be given as infinite.
LeafDistance leaf_distance(const PlacedLeaf& leaf, Vec3 p, const LeafDistance& most = {});

}  // namespace whittle
