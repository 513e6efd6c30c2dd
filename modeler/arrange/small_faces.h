// small_faces.h — the operands' surfaces cut along each other into triangles that meet in whole edges and corners only.
//
// Facets that other facets touch, and facets of one plane that touch, are triangulated anew, plane by plane; all others keep their triangles. Every
// edge has the same corners from whichever plane it is seen, because each plane cuts by closed exact sets.
// Source: Zhou et al., Mesh Arrangements for Solid Geometry (2016), for the whole; planes instead of triangles as the pieces to be cut are ours.
#pragma once

#include <functional>
#include <vector>

#include "csg/base/result.h"
#include "modeler/arrange/buried.h"

namespace whittle {

// Which facets lie on a small face. sign: +1 where the facet's outside is the face's front.
struct CoverEntry {
    std::uint32_t facet = 0;
    int sign = 1;
    auto operator<=>(const CoverEntry&) const = default;
};
using Cover = std::vector<CoverEntry>;

struct SmallFace {
    std::array<PointId, 3> v;     // counter-clockwise about the plane's normal, which points to the front
    std::uint32_t plane = 0;      // index into planes
    std::uint32_t cover = 0;      // index into covers
    std::uint32_t cluster = 0;    // kWhole: a triangle of an operand as it was
    static constexpr std::uint32_t kWhole = 0xFFFFFFFF;
};

struct SmallFaces {
    std::vector<ExactPlane> planes;  // a cluster's is planes[cluster]; n[axis] > 0 for its largest axis
    std::vector<Cover> covers;
    std::vector<SmallFace> faces;
    std::uint64_t pairs = 0;         // of pieces that were looked at
};

// Of the facets that are not buried. New points enter `patches.points`. `tree` holds patches.boxes. kScene fault where a mesh is not closed where it has to be, kInterrupted.
Result<SmallFaces> small_faces_of(Patches& patches, const BoxTree& tree, const Buried& buried, const std::function<bool()>& cancelled);

}  // namespace whittle
