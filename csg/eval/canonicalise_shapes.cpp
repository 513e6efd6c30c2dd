// canonicalise_shapes.cpp — primitives: sizes checked, round things as true curves or OpenSCAD's facets.

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "csg/eval/canonicaliser.h"
#include "csg/solid/facets.h"
#include "csg/solid/polyhedron.h"

namespace whittle {
namespace {

// Half of anything larger is still a size.
constexpr double kSmallestSize = 4 * std::numeric_limits<double>::min();

bool is_finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }
bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::shared_ptr<const Contours> single_contour(std::vector<Vec2> points) {
    return std::make_shared<const Contours>(Contours{std::move(points)});
}

}  // namespace

Made Canonicaliser::leaf(const SceneNode& node, Shape shape, const Placement& placement) {
    Made made;
    made.use.node = builder_.shape(std::move(shape));
    if (made.use.node == kEmptyNode) return {};
    made.dimension = builder_.is_2d(made.use.node) ? Dimension::kFlat : Dimension::kSolid;
    made.use.placement = placement;
    if (profile_depth_ == 0) made.use.label = builder_.label({{}, node.place, {}});
    return made;
}

bool Canonicaliser::is_positive(const SceneNode& node, const char* module, const char* what, double size) {
    if (size > kSmallestSize && std::isfinite(size)) return true;
    left_out(node.place, fmt::format("{}() has {} {:g}, left out", module, what, size));
    return false;
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Cube& what) {
    for (int i = 0; i < 3; ++i)
        if (!is_positive(node, "cube", "size", what.size[i])) return {};
    if (what.center) return leaf(node, shape::Box{-what.size / 2.0, what.size / 2.0});
    return leaf(node, shape::Box{Vec3(0), what.size});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Sphere& what) {
    if (!is_positive(node, "sphere", "radius", what.r)) return {};
    if (const int n = facets_of_circle(node, what.r)) return leaf(node, shape::FacetedBall{what.r, n});
    return leaf(node, shape::Ellipsoid{Vec3(what.r)});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Cylinder& what) {
    if (!is_positive(node, "cylinder", "height", what.h)) return {};
    for (const double r : {what.r1, what.r2})
        if (!(r >= 0 && std::isfinite(r))) return left_out(node.place, fmt::format("cylinder() has radius {:g}, left out", r));
    if (what.r1 == 0 && what.r2 == 0) return left_out(node.place, "cylinder() has radius 0 at both ends, left out");
    const double z0 = what.center ? -what.h / 2 : 0, z1 = what.center ? what.h / 2 : what.h;
    if (const int n = facets_of_circle(node, std::max(what.r1, what.r2))) return leaf(node, shape::FacetedFrustum{z0, z1, what.r1, what.r2, n});
    return leaf(node, shape::Frustum{z0, z1, what.r1, what.r2});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Square& what) {
    for (int i = 0; i < 2; ++i)
        if (!is_positive(node, "square", "size", what.size[i])) return {};
    if (what.center) return leaf(node, shape::Rectangle{-what.size / 2.0, what.size / 2.0});
    return leaf(node, shape::Rectangle{Vec2(0), what.size});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Circle& what) {
    if (!is_positive(node, "circle", "radius", what.r)) return {};
    if (const int n = facets_of_circle(node, what.r)) return leaf(node, shape::Polygon{single_contour(circle_points(what.r, n))});
    return leaf(node, shape::Disc{what.r});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Polygon& what) {
    for (const Vec2& p : what.points)
        if (!is_finite(p)) return left_out(node.place, "polygon() has a point that is not finite, left out");
    Contours contours;
    if (what.paths.empty()) contours.push_back(what.points);
    for (const auto& path : what.paths) {
        auto& contour = contours.emplace_back();
        for (const std::int64_t i : path) {
            if (i >= 0 && i < static_cast<std::int64_t>(what.points.size())) contour.push_back(what.points[static_cast<std::size_t>(i)]);
            else left_out(node.place, fmt::format("Point index {} is out of bounds (from paths of polygon())", i));
        }
    }
    for (auto& contour : contours) {
        contour.erase(std::unique(contour.begin(), contour.end()), contour.end());
        while (contour.size() > 1 && contour.front() == contour.back()) contour.pop_back();
    }
    contours.erase(std::remove_if(contours.begin(), contours.end(), [](const auto& c) { return c.size() < 3; }), contours.end());
    if (contours.empty()) return what.points.empty() ? Made{} : left_out(node.place, "polygon() has fewer than three different points, left out");
    return leaf(node, shape::Polygon{std::make_shared<const Contours>(std::move(contours))});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Torus& what) {
    if (!(what.r1 >= 0 && std::isfinite(what.r1))) return left_out(node.place, fmt::format("torus() has radius {:g}, left out", what.r1));
    if (!is_positive(node, "torus", "tube radius", what.r2)) return {};
    if (what.r1 == 0) return leaf(node, shape::Ellipsoid{Vec3(what.r2)});
    return leaf(node, shape::Torus{what.r1, what.r2});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Ellipsoid& what) {
    for (int i = 0; i < 3; ++i)
        if (!is_positive(node, "ellipsoid", "radius", what.r[i])) return {};
    return leaf(node, shape::Ellipsoid{what.r});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::HalfSpace& what) {
    if (!is_finite(what.n) || !std::isfinite(what.d) || what.n == Vec3(0)) return left_out(node.place, "halfspace() needs a finite normal and offset, left out");
    return leaf(node, shape::HalfSpace{what.n, what.d});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Quadric& what) {
    const auto& c = what.c;
    if (!std::all_of(c.begin(), c.end(), [](double x) { return std::isfinite(x); })) return left_out(node.place, "quadric() needs ten finite numbers, left out");
    if (std::any_of(c.begin(), c.begin() + 6, [](double x) { return x != 0; })) return leaf(node, shape::Quadric{c});
    const Vec3 n{c[6], c[7], c[8]};
    if (n == Vec3(0)) return left_out(node.place, "quadric() is all of space or nothing, left out");
    return leaf(node, shape::HalfSpace{n, -c[9]});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::Capsule& what) {
    if (!is_positive(node, "capsule", "radius", what.r)) return {};
    if (!is_finite(what.p) || !is_finite(what.q)) return left_out(node.place, "capsule() has an end that is not finite, left out");
    if (what.p == what.q) return leaf(node, shape::Ellipsoid{Vec3(what.r)}, Placement::translation(what.p));
    return leaf(node, shape::Capsule{what.p, what.q, what.r});
}

Made Canonicaliser::primitive(const SceneNode& node, const scene::RoundCube& what) {
    for (int i = 0; i < 3; ++i)
        if (!is_positive(node, "roundcube", "size", what.size[i])) return {};
    if (!(what.r >= 0 && std::isfinite(what.r))) return left_out(node.place, fmt::format("roundcube() has radius {:g}, left out", what.r));
    if (2 * what.r > std::min({what.size.x, what.size.y, what.size.z}))
        return left_out(node.place, fmt::format("roundcube() of radius {:g} does not fit its size, left out", what.r));
    const Vec3 lo = what.center ? -what.size / 2.0 : Vec3(0), hi = what.center ? what.size / 2.0 : what.size;
    if (what.r == 0) return leaf(node, shape::Box{lo, hi});
    return leaf(node, shape::RoundBox{lo, hi, what.r});
}

// OpenSCAD's faces are clockwise seen from outside; a solid's are counter-clockwise.
Made Canonicaliser::primitive(const SceneNode& node, const scene::Polyhedron& what) {
    for (const Vec3& p : what.points)
        if (!is_finite(p)) return left_out(node.place, "polyhedron() has a point that is not finite, left out");
    FacetList mesh;
    mesh.points = what.points;
    for (const auto& face : what.faces) {
        auto& facet = mesh.facets.emplace_back();
        for (auto i = face.rbegin(); i != face.rend(); ++i) {
            if (*i >= 0 && *i < static_cast<std::int64_t>(what.points.size())) facet.push_back(static_cast<std::uint32_t>(*i));
            else left_out(node.place, fmt::format("Point index {} is out of bounds (from faces of polyhedron())", *i));
        }
    }
    if (mesh.points.empty() && mesh.facets.empty()) return {};
    mesh = welded(mesh);
    if (const std::size_t open = open_edges(mesh); open > 0 || mesh.facets.empty())
        return left_out(node.place, fmt::format("polyhedron() is not closed ({} open edges), left out", open),
                        "every edge needs two faces that run along it in opposite directions, each clockwise seen from outside");
    mesh = with_flat_facets(mesh);
    if (signed_volume(mesh) < 0) {
        diagnostics_.add(Severity::kWarning, node.place, "polyhedron() is inside out, turned", "list each face clockwise seen from outside");
        for (auto& facet : mesh.facets) std::reverse(facet.begin(), facet.end());
    }
    return leaf(node, shape::Polyhedron{std::make_shared<const FacetList>(std::move(mesh))});
}

}  // namespace whittle
