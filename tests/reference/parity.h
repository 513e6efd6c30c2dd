// parity.h — solids given by facets: inside after an odd number of them along the ray.
//
// A facet is a convex piece of a plane between lines; the ray passes it if it passes all its lines on one side. A ray that meets a line or lies in the
// plane is nudged symbolically (csg/span/perturbation.h), by the same rule as everything else.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "csg/span/ray.h"
#include "tests/reference/dyadic.h"

namespace whittle::reference {

using Triple = std::array<Dyadic, 3>;

struct Line {
    Triple point, direction;
};

// The plane's support may be another's by a snap, and `own` its own: the lines say whether there is a crossing; `support` says where, if that is near the
// facet, otherwise `own`.
struct Facet {
    std::uint32_t support = 0, own = 0;
    Triple normal;
    std::vector<Line> lines;
};

Triple cross(const Triple& a, const Triple& b);
Dyadic dot(const Triple& a, const Triple& b);
Triple minus(const Triple& a, const Triple& b);

// Closed: a bounded mesh, or the walls of a prism without end along `along` (0 otherwise), `across` being another direction.
struct Faceted {
    std::vector<Facet> facets;
    Triple along, across;
};

// The facets that the ray's whole line passes.
std::vector<std::size_t> passed(const std::vector<Facet>& facets, const Ray& ray);

// How far from its box, in parts of its greatest side, a facet's crossing may lie where its class is another's plane.
inline constexpr double kFacetReach = 0.000297;

// Is the ray at t that near the facet; of a wall, all seen along the prism's `along`?
bool is_near(const Facet& facet, const Triple& along, const Ray& ray, const Dyadic& t);

// For a ray along a prism, which passes no wall: is it inside?
bool is_along(const Faceted& solid, const Ray& ray);
bool holds_along(const Faceted& solid, const Ray& ray);

}  // namespace whittle::reference
