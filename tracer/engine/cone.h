// cone.h — a thin cone of rays about a ray: which parts of it meet which face of the solid first?
//
// A cone's section at a distance is an ellipse, the image of the unit disc. Near the axis each half-space covers of it what a straight edge leaves. Where the
// axis crosses a half-space's border the formula is asked at 64 points of the disc at once, a bit each: those where that border decides meet a face there.
// So the disc falls into parts by the face met first; one ray through the middle of each, weighed by its area, together stand for the whole cone. An area
// that a single edge divides is divided exactly. Cones through extruded polygons, meshes or what moves are not divided.
// Sources: Amanatides, Ray Tracing with Cones (1984); Carpenter, The A-buffer (1984), for the masks.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>

#include "tracer/engine/engine.h"

namespace whittle {

// The section at t is the unit disc's image under a matrix whose square is the sum of those of: a disc of radius start + spread * t; the ellipse with the
// half axes near_u and near_v, shrinking to nothing at t = reach (places that the rays come from); and that of far_u and far_v, growing from nothing at 0
// to the whole at `reach` (places they go to). The direction is a unit vector; what of the ellipses lies along it does not count.
struct Cone {
    Ray axis;
    double start = 0, spread = 0;
    Vec3 near_u{0}, near_v{0}, far_u{0}, far_v{0};
    double reach = std::numeric_limits<double>::infinity();
    Vec3 right{1, 0, 0}, up{0, 1, 0};  // orthonormal: the disc is laid out by these
};

// `share` of the cone has its middle at `off` from the axis in the section at t, where its face is; what meets none, where that of most points is.
struct ConePart {
    double share = 1;
    double t = 0;
    Vec3 off{0};
};

// The parts that a cone is divided in, by the face that they meet, the nearest first. None: it is not divided.
struct ConeParts {
    static constexpr std::size_t kMost = 8;
    std::array<ConePart, kMost> part;
    std::size_t count = 0;

    bool divided() const { return count > 0; }
    const ConePart* begin() const { return part.data(); }
    const ConePart* end() const { return part.data() + count; }
};

// Holds the memory that dividing needs.
class ConeSplitter {
public:
    ConeSplitter();
    ~ConeSplitter();
    ConeSplitter(const ConeSplitter&) = delete;
    ConeSplitter& operator=(const ConeSplitter&) = delete;

    // `t_hit`: where the axis meets the solid, infinite where it does not; `hit`: the classes that it meets there, null where they are not known. Faces behind
    // it do not count, those that the axis departs from neither.
    ConeParts split(const Program& program, const Cone& cone, double t_hit, const Departure* hit = nullptr);

private:
    class Search;
    std::unique_ptr<Search> search_;
};

// Of a disc of radius 1 cut at the distance `offset` in [0, 1] from its middle: the share of the smaller part, and how far its centroid lies out.
struct DiscCut {
    double share = 0, centroid = 0;
};
DiscCut cut_disc(double offset);

}  // namespace whittle
