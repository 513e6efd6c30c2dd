// tessellate_convex.cpp — a convex body as the exact hull of points of its border.
//
// Discs, segments and ellipsoids are divided as those shapes are elsewhere. Sums of several are approached: the point farthest along a facet's normal joins where it
// is farther out than half the tolerance. Flat faces begin with their rims: what is only near them would make facets that are a little below.
#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/convex_body.h"
#include "csg/solid/convex_hull.h"
#include "modeler/mesh/tessellate.h"

namespace whittle {
namespace {

constexpr int kMostRounds = 24;  // each leaves about a quarter of what was missing

double radius_of(const BallImage& image) { return std::sqrt(std::max({glm::dot(image.u, image.u), glm::dot(image.v, image.v), glm::dot(image.w, image.w)})); }

// Half the tolerance: the hull of points on a ball joins them otherwise than the rows do that they are chosen for.
CurveRule of_unit(CurveRule rule, double radius) {
    rule.scale *= radius;
    rule.largest /= 2;
    rule.share_of_radius /= 2;
    return rule;
}

// Points on the border of the image, about the origin.
std::vector<Vec3> border_points(const BallImage& image, const CurveRule& rule) {
    const CurveRule unit = of_unit(rule, radius_of(image));
    std::vector<Vec3> out;
    if (image.w != Vec3(0)) {
        for (const Vec3& p : tessellate_rounded(Vec3(0), Vec3(0), 1, unit).mesh.points) out.push_back(p.x * image.u + p.y * image.v + p.z * image.w);
    } else if (image.v != Vec3(0)) {
        const int n = unit.turn(1);
        for (int i = 0; i < n; ++i) out.push_back(cosd(360.0 * i / n) * image.u + sind(360.0 * i / n) * image.v);
    } else {
        out = {image.u, -image.u};
    }
    return out;
}

// How far out the facet's normal finds the body still, and where.
struct Beyond { double distance; Vec3 point; };
Beyond beyond(const ConvexParts& parts, const FacetList& hull, const std::vector<std::uint32_t>& facet) {
    const Vec3 &a = hull.points[facet[0]], &b = hull.points[facet[1]], &c = hull.points[facet[2]];
    const Vec3 across = glm::cross(b - a, c - a), n = across / glm::length(across);
    if (!std::isfinite(n.x + n.y + n.z)) return {0, a};
    const Vec3 p = farthest_point(parts, n);
    return {glm::dot(n, p - a), p};
}

std::vector<Vec3> rim_points(const ConvexHullBody& body, const FlatFace& face, int count) {
    const Vec3 x = glm::normalize(glm::cross(std::abs(face.n.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), face.n)), y = glm::cross(face.n, x);
    std::vector<Vec3> out;
    for (int i = 0; i < count; ++i) out.push_back(farthest_point(body.parts, body.size, face, cosd(360.0 * i / count) * x + sind(360.0 * i / count) * y));
    return out;
}

std::optional<FacetList> approached(const ConvexParts& parts, std::vector<Vec3> points, double tolerance) {
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0) points.push_back(farthest_point(parts, Vec3(x, y, z)));
    std::optional<FacetList> hull;
    for (int round = 0; round < kMostRounds; ++round) {
        hull = convex_hull_of(points);
        if (!hull) return hull;
        points = hull->points;
        for (const auto& facet : hull->facets)
            if (const Beyond more = beyond(parts, *hull, facet); more.distance > tolerance) points.push_back(more.point);
        if (points.size() == hull->points.size()) return hull;
    }
    return convex_hull_of(points);
}

}  // namespace

Result<Tessellation> tessellate_convex(const shape::ConvexBody& s, const CurveRule& rule) {
    std::vector<Vec3> points;
    double chord = 0, largest = 0;
    bool sums = false;
    for (const ConvexPart& part : s.hull->parts) {
        for (const BallImage& image : part.images) largest = std::max(largest, radius_of(image));
        sums = sums || part.images.size() > 1;
        if (part.images.empty()) points.push_back(part.centre);
        if (part.images.size() != 1) continue;
        for (const Vec3& p : border_points(part.images[0], rule)) points.push_back(part.centre + p);
        chord = std::max(chord, rule.chord(radius_of(part.images[0])));
    }
    if (sums) chord = std::max(chord, rule.chord(largest));
    for (const FlatFace& face : s.hull->faces)
        if (sums)
            for (const Vec3& p : rim_points(*s.hull, face, of_unit(rule, largest).turn(1))) points.push_back(p);
    const auto hull = sums ? approached(s.hull->parts, std::move(points), chord / 2) : convex_hull_of(std::move(points));
    if (!hull) return fail(Fault::kScene, "a convex body that encloses nothing");
    Tessellation out;
    out.mesh.points = hull->points;
    for (const auto& f : hull->facets)
        for (std::size_t i = 1; i + 1 < f.size(); ++i) out.mesh.triangles.push_back({f[0], f[i], f[i + 1]});
    out.error = chord * rule.scale;
    return out;
}

}  // namespace whittle
