// facet_lists.cpp — facets_of: the shapes that are bounded by facets, as lists of them.

#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/ear_clipping.h"
#include "csg/solid/facets.h"
#include "csg/solid/polyhedron.h"
#include "csg/solid/predicates.h"
#include "csg/solid/profile.h"

namespace whittle {
namespace {

using Facet = std::vector<std::uint32_t>;

// Corners beyond which a list is refused: they would fill some gigabytes, and no author means them.
constexpr double kMostCorners = 1 << 26;

tl::unexpected<Error> cannot(const char* what) { return fail(Fault::kScene, what); }
constexpr double kSmoothTolerance = 0x1p-12;  // of the profile's size: sides of twists without slices; finer costs quadratically
constexpr const char* kTooMany = "more facets than memory should hold: lower $fn or slices";

bool too_many(double layers, double corners_each) { return layers * corners_each > kMostCorners; }

FacetList box_facets(const shape::Box& s) {
    FacetList out;
    for (int i = 0; i < 8; ++i) out.points.push_back({i & 1 ? s.hi.x : s.lo.x, i & 2 ? s.hi.y : s.lo.y, i & 4 ? s.hi.z : s.lo.z});
    out.facets = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return out;
}

void add_ring(FacetList& out, double r, double z, int n) {
    for (const Vec2& p : circle_points(r, n)) out.points.push_back({p.x, p.y, z});
}
// All n corners from `first` on, as a facet that looks up or down.
Facet ring_facet(std::uint32_t first, int n, int up) {
    Facet f;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(n); ++i) f.push_back(first + (up > 0 ? i : static_cast<std::uint32_t>(n) - 1 - i));
    return f;
}
// Quads between a ring of n corners and the one above it.
void add_belt(FacetList& out, std::uint32_t lower, std::uint32_t upper, int n) {
    const auto count = static_cast<std::uint32_t>(n);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t j = (i + 1) % count;
        out.facets.push_back({lower + i, lower + j, upper + j, upper + i});
    }
}

Result<FacetList> ball_facets(const shape::FacetedBall& s) {
    FacetList out;
    const int rings = (s.n + 1) / 2;
    if (too_many(rings, s.n)) return cannot(kTooMany);
    for (int i = 0; i < rings; ++i) {
        const double phi = 180.0 * (i + 0.5) / rings;
        add_ring(out, s.r * sind(phi), s.r * cosd(phi), s.n);
    }
    const auto n = static_cast<std::uint32_t>(s.n);
    out.facets.push_back(ring_facet(0, s.n, 1));
    for (std::uint32_t i = 0; i + 1 < static_cast<std::uint32_t>(rings); ++i) add_belt(out, (i + 1) * n, i * n, s.n);
    out.facets.push_back(ring_facet(static_cast<std::uint32_t>(rings - 1) * n, s.n, -1));
    return out;
}

FacetList frustum_facets(const shape::FacetedFrustum& s) {
    FacetList out;
    const auto n = static_cast<std::uint32_t>(s.n);
    if (s.r0 > 0) add_ring(out, s.r0, s.z0, s.n);
    if (s.r0 > 0) out.facets.push_back(ring_facet(0, s.n, -1));
    const auto upper = static_cast<std::uint32_t>(out.points.size());
    if (s.r1 > 0) add_ring(out, s.r1, s.z1, s.n);
    if (s.r1 > 0) out.facets.push_back(ring_facet(upper, s.n, 1));
    if (s.r0 > 0 && s.r1 > 0) {
        add_belt(out, 0, upper, s.n);
        return out;
    }
    const auto apex = static_cast<std::uint32_t>(out.points.size());
    out.points.push_back({0, 0, s.r0 > 0 ? s.z1 : s.z0});
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = i, b = (i + 1) % n;
        if (s.r0 > 0) out.facets.push_back({a, b, apex});
        else out.facets.push_back({b, a, apex});
    }
    return out;
}

// A profile as one list of corners, its contours as indices, and its inside as triangles.
struct Outline {
    std::vector<Vec2> points;
    std::vector<Facet> contours;
    std::vector<IndexTriangle> inside;
};

double profile_size(const Solid& solid, NodeId profile) {
    const Bounds& box = solid.bounds(profile);
    return std::max(glm::length(box.lo), glm::length(box.hi));
}

// `longest`: sides are cut into pieces no longer than this (0: not at all).
Result<Outline> outline_of(const Solid& solid, NodeId profile, double tolerance, double longest = 0) {
    Outline out;
    for (const auto& contour : contours_of(solid, profile, tolerance > 0 ? tolerance : profile_size(solid, profile) * kProfileTolerance)) {
        Facet& ring = out.contours.emplace_back();
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const Vec2 a = contour[i], b = contour[(i + 1) % contour.size()];
            const double pieces = longest > 0 ? std::max(1.0, std::ceil(glm::distance(a, b) / longest)) : 1;
            if (too_many(pieces, 1)) return cannot(kTooMany);
            for (double k = 0; k < pieces; ++k) {
                ring.push_back(static_cast<std::uint32_t>(out.points.size()));
                out.points.push_back(a + (b - a) * (k / pieces));
            }
        }
    }
    auto inside = ear_clipped(out.points, out.contours);
    if (!inside) return cannot("the contours of a profile cross");
    out.inside = std::move(*inside);
    return out;
}

void add_lid(FacetList& out, const Outline& outline, std::uint32_t first, bool turned) {
    for (const auto& t : outline.inside) {
        if (turned) out.facets.push_back({first + t[0], first + t[2], first + t[1]});
        else out.facets.push_back({first + t[0], first + t[1], first + t[2]});
    }
}

// The side of a slice is cut along its shorter diagonal; of equal ones along the one that follows the twist.
void add_side(FacetList& out, std::uint32_t a, std::uint32_t b, std::uint32_t above, double twist_deg) {
    const std::uint32_t c = b + above, d = a + above;
    const double ac = glm::distance(out.points[a], out.points[c]), bd = glm::distance(out.points[b], out.points[d]);
    const bool along_ac = std::fabs(ac - bd) <= kEqualDiagonals ? twist_deg >= 0 : ac < bd;
    if (along_ac) {
        out.facets.push_back({a, b, c});
        out.facets.push_back({a, c, d});
    } else {
        out.facets.push_back({a, b, d});
        out.facets.push_back({b, c, d});
    }
}

// Equal corners as one, facets without area dropped.
FacetList tidied(const FacetList& mesh) {
    FacetList out = welded(mesh);
    out.facets.erase(std::remove_if(out.facets.begin(), out.facets.end(), [&](const Facet& f) {
        return f.size() == 3 && are_collinear(out.points[f[0]], out.points[f[1]], out.points[f[2]]);
    }), out.facets.end());
    return out;
}

// A twisted or unevenly scaled extrusion without slices of its own, within `error` of the true surface: half of it for the chord of a turn,
// half for the bend of a side between two slices, a quarter of its length times the slice's turn.
struct SmoothCut {
    double slices = 1, longest = 0;
};
SmoothCut smooth_cut(const shape::Extrusion& s, double size, double error) {
    const double turn = std::abs(s.twist_deg) * kRadiansPerDegree + std::abs(1 - s.scale_top.x) + std::abs(1 - s.scale_top.y);
    const double slices = std::max(1.0, std::ceil(turn * std::sqrt(size / (4 * error))));
    return {slices, 2 * error * slices / turn};
}

Result<FacetList> extrusion_facets(const Solid& solid, const shape::Extrusion& s, double tolerance) {
    const bool even = s.twist_deg == 0 && s.scale_top.x == s.scale_top.y;
    const bool smooth = s.slices == 0 && !even;
    const double size = profile_size(solid, s.profile), error = tolerance > 0 ? tolerance : size * kSmoothTolerance;
    const SmoothCut cut = smooth ? smooth_cut(s, size, error) : SmoothCut{};
    if (too_many(cut.slices, 1)) return cannot(kTooMany);
    const auto outline = outline_of(solid, s.profile, smooth ? error : tolerance, cut.longest);
    if (!outline) return tl::unexpected(outline.error());
    const int slices = even ? 1 : smooth ? static_cast<int>(cut.slices) : s.slices;
    const auto layer = static_cast<std::uint32_t>(outline->points.size());
    if (too_many(slices + 1.0, layer)) return cannot(kTooMany);
    FacetList out;
    for (int j = 0; j <= slices; ++j) {
        const double turn = s.twist_deg * j / slices, c = cosd(-turn), n = sind(-turn);
        const Vec2 scale{1 - (1 - s.scale_top.x) * j / slices, 1 - (1 - s.scale_top.y) * j / slices};
        const double z = j == slices ? s.z1 : s.z0 + (s.z1 - s.z0) * j / slices;
        for (const Vec2& p : outline->points) out.points.push_back({scale.x * (c * p.x - n * p.y), scale.y * (n * p.x + c * p.y), z});
    }
    add_lid(out, *outline, 0, true);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(slices); ++j)
        for (const Facet& ring : outline->contours)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const std::uint32_t a = j * layer + ring[i], b = j * layer + ring[(i + 1) % ring.size()];
                if (even) out.facets.push_back({a, b, b + layer, a + layer});
                else add_side(out, a, b, layer, s.twist_deg);
            }
    add_lid(out, *outline, static_cast<std::uint32_t>(slices) * layer, false);
    return tidied(out);
}

// Layer j of a revolution stands at this angle: OpenSCAD's whole turn starts on -x and runs clockwise, a part runs counter-clockwise.
Vec2 direction_of(const shape::Revolution& s, int j) {
    const double a = s.angle_deg == 360 ? 90 - s.start_deg + 360.0 * j / s.fragments : 90 - s.start_deg - j * s.angle_deg / s.fragments;
    return {sind(a), cosd(a)};
}

Result<FacetList> revolution_facets(const Solid& solid, const shape::Revolution& s, double tolerance) {
    if (s.fragments == 0) return cannot("a true surface of revolution has no facets");
    if (solid.bounds(s.profile).lo.x < 0) return cannot("a profile of a revolution crosses its axis");
    const auto outline = outline_of(solid, s.profile, tolerance);
    if (!outline) return tl::unexpected(outline.error());
    const bool whole = s.angle_deg == 360;
    const auto layer = static_cast<std::uint32_t>(outline->points.size()), n = static_cast<std::uint32_t>(s.fragments);
    if (too_many(s.fragments + 1.0, layer)) return cannot(kTooMany);
    FacetList out;
    for (int j = 0; j < s.fragments + (whole ? 0 : 1); ++j) {
        const Vec2 d = direction_of(s, j);
        for (const Vec2& p : outline->points) out.points.push_back({p.x * d.x, p.x * d.y, p.y});
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t here = j * layer, next = (whole ? (j + 1) % n : j + 1) * layer;
        const std::uint32_t from = whole ? next : here, to = whole ? here : next;  // counter-clockwise
        for (const Facet& ring : outline->contours)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
                if (outline->points[a].x == 0 && outline->points[b].x == 0) continue;
                out.facets.push_back({a + from, a + to, b + to, b + from});
            }
    }
    if (!whole) {
        add_lid(out, *outline, 0, false);
        add_lid(out, *outline, n * layer, true);
    }
    return tidied(out);
}

struct FacetsOf {
    const Solid& solid;
    double tolerance;

    Result<FacetList> operator()(const shape::Box& s) const { return box_facets(s); }
    Result<FacetList> operator()(const shape::FacetedBall& s) const { return ball_facets(s); }
    Result<FacetList> operator()(const shape::FacetedFrustum& s) const { return frustum_facets(s); }
    Result<FacetList> operator()(const shape::Polyhedron& s) const { return with_convex_facets(*s.mesh); }
    Result<FacetList> operator()(const shape::Extrusion& s) const { return extrusion_facets(solid, s, tolerance); }
    Result<FacetList> operator()(const shape::Revolution& s) const { return revolution_facets(solid, s, tolerance); }
    Result<FacetList> operator()(const auto&) const { return cannot("a curved or flat shape has no facets"); }
};

}  // namespace

Result<FacetList> facets_of(const Solid& solid, NodeId node, double tolerance) {
    const auto* s = std::get_if<Shape>(&solid.node(node));
    if (!s) return cannot("a combination has no facets of its own");
    return std::visit(FacetsOf{solid, tolerance}, *s);
}

}  // namespace whittle
