// deviation.h — how far does one surface stray from another? A bound that holds for every point, not for samples.
//
// The distance to one triangle is a convex function, so over a piece of surface it is greatest at the piece's corners. A facet is halved until each piece
// has all its corners near one and the same triangle of the other mesh. The work grows with the length of edges over the distance: cutting along the prisms of
// the other mesh's triangles was tried and makes more pieces, not fewer.
// Source: Tang, Lee, Kim, Interactive Hausdorff distance computation for general polygonal models (2009), for the bound.
#pragma once

#include <memory>
#include <optional>

#include "modeler/mesh/mesh.h"

namespace whittle {

// A bound on the distance of any point of `a` from the nearest of `b`, at most `most`; nothing where none that small was found, by the work that is
// worth while.
std::optional<double> deviation_within(const Mesh& a, const Mesh& b, double most);

// The same both ways: a bound on the Hausdorff distance.
std::optional<double> hausdorff_within(const Mesh& a, const Mesh& b, double most);

// Which points lie near a surface?
class Nearness {
public:
    explicit Nearness(const Mesh& surface);
    ~Nearness();
    Nearness(const Nearness&) = delete;
    Nearness& operator=(const Nearness&) = delete;
    bool within(const Vec3& p, double distance) const;

private:
    struct Facets;
    std::unique_ptr<const Facets> facets_;
};

}  // namespace whittle
