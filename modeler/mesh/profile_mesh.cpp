// Booleans of polygons are Clipper's (Vatti), on integers: exact but for crossings, which are rounded to the grid.
#include "modeler/mesh/profile_mesh.h"

#include <map>

#include <polyclipping/clipper.hpp>

#include "csg/base/degrees.h"
#include "csg/solid/clean_paths.h"
#include "csg/solid/facets.h"
#include "csg/solid/parabola.h"
#include "modeler/mesh/grid.h"

namespace whittle {
namespace {

namespace clip = ClipperLib;

// The placement's effect on the plane z = 0.
Vec2 placed(const Placement& a, const Vec2& p) { return {a.m[0] * p.x + a.m[1] * p.y + a.m[3], a.m[4] * p.x + a.m[5] * p.y + a.m[7]}; }

double largest_stretch(const Placement& a) {
    const double p = a.m[0] * a.m[0] + a.m[4] * a.m[4], q = a.m[1] * a.m[1] + a.m[5] * a.m[5], r = a.m[0] * a.m[1] + a.m[4] * a.m[5];
    return std::sqrt((p + q + std::sqrt((p - q) * (p - q) + 4 * r * r)) / 2);
}

clip::Paths combined(clip::ClipType type, const clip::Paths& a, const clip::Paths& b, clip::PolyFillType fill) {
    clip::Clipper clipper;
    clipper.PreserveCollinear(true);
    clipper.StrictlySimple(true);
    clipper.AddPaths(a, clip::ptSubject, true);
    clipper.AddPaths(b, clip::ptClip, true);
    clip::Paths out;
    clipper.Execute(type, out, fill, fill);
    return out;
}

class Contouring {
public:
    Contouring(const Solid& solid, const CurveRule& rule, const Grid& grid) : solid_(solid), rule_(rule), grid_(grid) {}

    Result<clip::Paths> paths(NodeId id, const Placement& placement) {
        const Node& node = solid_.node(id);
        if (const auto* shape = std::get_if<Shape>(&node)) return shape_paths(*shape, placement);
        const auto& combination = std::get<Combination>(node);
        clip::Paths result;
        for (std::size_t i = 0; i < combination.operands.size(); ++i) {
            const Use& use = combination.operands[i];
            auto next = paths(use.node, placement * use.placement);
            if (!next) return next;
            if (i == 0) {
                result = std::move(*next);
                continue;
            }
            if (combination.op == SetOp::kUnion) {
                result.insert(result.end(), next->begin(), next->end());
                continue;
            }
            if (i == 1) result = settled(result);
            result = combined(combination.op == SetOp::kIntersection ? clip::ctIntersection : clip::ctDifference, result, *next, clip::pftNonZero);
        }
        return combination.op == SetOp::kUnion && combination.operands.size() > 1 ? settled(result) : result;
    }

    ProfileMesh finished(const clip::Paths& paths) const {
        ProfileMesh out;
        out.error = error_;
        out.per_mm = grid_.per_mm;
        for (const clip::Path& path : clean_paths(paths)) {
            std::vector<std::uint32_t> contour;
            for (const clip::IntPoint& p : path) {
                contour.push_back(static_cast<std::uint32_t>(out.points.size()));
                const auto known = corners_.find({p.X, p.Y});
                out.points.push_back(known != corners_.end() ? known->second
                                                             : Vec2{grid_.mm(static_cast<double>(p.X)), grid_.mm(static_cast<double>(p.Y))});
            }
            out.contours.push_back(std::move(contour));
        }
        return out;
    }

private:
    // The circle that the curve hugs in its middle has half the chord, squared, over the control point's height as radius: the rule reads it, at most the chord.
    static int chords_of(const shape::ParabolicSegment& s, const CurveRule& rule) {
        const double half = glm::length(s.b - s.a) / 2, rise = glm::length(s.a - 2.0 * s.c + s.b) / 2;
        const double radius = std::min(half * half / rise, 2 * half);
        int n = parabola_chords(s, rule.chord(radius));
        if (rule.angle_deg) n = std::max(n, static_cast<int>(std::ceil(turn_deg(s) / *rule.angle_deg)));
        return n;
    }
    static double turn_deg(const shape::ParabolicSegment& s) {
        const Vec2 u = s.c - s.a, v = s.b - s.c;
        return std::fabs(std::atan2(u.x * v.y - u.y * v.x, glm::dot(u, v))) / kRadiansPerDegree;
    }

    static clip::Paths settled(const clip::Paths& paths) { return combined(clip::ctUnion, paths, {}, clip::pftNonZero); }

    Result<clip::Paths> shape_paths(const Shape& shape, const Placement& placement) {
        Contours contours;
        if (const auto* disc = std::get_if<shape::Disc>(&shape)) {
            CurveRule rule = rule_;
            rule.scale *= largest_stretch(placement);
            contours.push_back(circle_points(disc->r, rule.turn(disc->r)));
            error_ = std::max(error_, rule.chord(disc->r) * rule.scale);
        } else if (const auto* box = std::get_if<shape::Rectangle>(&shape)) {
            contours.push_back({box->lo, {box->hi.x, box->lo.y}, box->hi, {box->lo.x, box->hi.y}});
        } else if (const auto* polygon = std::get_if<shape::Polygon>(&shape)) {
            contours = *polygon->contours;
            error_ = std::max(error_, polygon->deviation * largest_stretch(placement) * rule_.scale);
        } else if (const auto* segment = std::get_if<shape::ParabolicSegment>(&shape)) {
            CurveRule rule = rule_;
            rule.scale *= largest_stretch(placement);
            contours.push_back(parabola_corners(*segment, chords_of(*segment, rule)));
            error_ = std::max(error_, parabola_error(*segment, static_cast<int>(contours.back().size()) - 1) * rule.scale);
        } else {
            return fail(Fault::kScene, "a 3D shape stands where a 2D one is needed");
        }
        clip::Paths paths;
        for (const auto& contour : contours) {
            clip::Path path;
            for (const Vec2& p : contour) {
                const Vec2 q = placed(placement, p);
                path.emplace_back(grid_.snapped(q.x), grid_.snapped(q.y));
                corners_.try_emplace({path.back().X, path.back().Y}, q);
            }
            paths.push_back(std::move(path));
        }
        return combined(clip::ctUnion, paths, {}, clip::pftEvenOdd);
    }

    const Solid& solid_;
    const CurveRule& rule_;
    Grid grid_;
    double error_ = 0;
    std::map<std::pair<clip::cInt, clip::cInt>, Vec2> corners_;  // the author's own numbers
};

}  // namespace

Result<ProfileMesh> profile_contours(const Solid& solid, NodeId node, const CurveRule& rule) {
    const Bounds& box = solid.bounds(node);
    if (box.empty()) return ProfileMesh{};
    const Grid grid = Grid::for_size(std::max({std::fabs(box.lo.x), std::fabs(box.hi.x), std::fabs(box.lo.y), std::fabs(box.hi.y)}));
    try {
        Contouring contouring(solid, rule, grid);
        auto paths = contouring.paths(node, Placement{});
        if (!paths) return tl::unexpected(paths.error());
        return contouring.finished(*paths);
    } catch (const std::exception& e) {
        return fail(Fault::kScene, std::string("a 2D shape cannot be combined: ") + e.what());
    }
}

ProfileMesh right_half(const ProfileMesh& profile) {
    const Grid grid{profile.per_mm};
    clip::Paths paths;
    clip::cInt lowest = 0, highest = 0, rightmost = 0;
    for (const auto& contour : profile.contours) {
        clip::Path path;
        for (const std::uint32_t v : contour) {
            path.emplace_back(grid.snapped(profile.points[v].x), grid.snapped(profile.points[v].y));
            lowest = std::min(lowest, path.back().Y);
            highest = std::max(highest, path.back().Y);
            rightmost = std::max(rightmost, path.back().X);
        }
        paths.push_back(std::move(path));
    }
    const clip::Path half{{0, lowest}, {rightmost, lowest}, {rightmost, highest}, {0, highest}};
    ProfileMesh out;
    out.error = profile.error;
    out.per_mm = profile.per_mm;
    for (const clip::Path& path : clean_paths(combined(clip::ctIntersection, paths, {half}, clip::pftNonZero))) {
        std::vector<std::uint32_t> contour;
        for (const clip::IntPoint& p : path) {
            contour.push_back(static_cast<std::uint32_t>(out.points.size()));
            out.points.emplace_back(grid.mm(static_cast<double>(p.X)), grid.mm(static_cast<double>(p.Y)));
        }
        out.contours.push_back(std::move(contour));
    }
    return out;
}

ProfileMesh with_sides_cut(const ProfileMesh& profile, const std::function<int(const Vec2&, const Vec2&)>& parts) {
    ProfileMesh out;
    out.error = profile.error;
    out.per_mm = profile.per_mm;
    for (const auto& contour : profile.contours) {
        std::vector<std::uint32_t> finer;
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const Vec2 &a = profile.points[contour[i]], &b = profile.points[contour[(i + 1) % contour.size()]];
            const int n = parts(a, b);
            for (int k = 0; k < n; ++k) {
                finer.push_back(static_cast<std::uint32_t>(out.points.size()));
                out.points.push_back(k == 0 ? a : a + (b - a) * (static_cast<double>(k) / n));
            }
        }
        out.contours.push_back(std::move(finer));
    }
    return out;
}

std::optional<std::vector<Triangle>> profile_triangles(const ProfileMesh& profile) {
    const Grid grid{profile.per_mm};
    std::vector<GridPoint2> points;
    points.reserve(profile.points.size());
    for (const Vec2& p : profile.points) points.push_back({grid.snapped(p.x), grid.snapped(p.y)});
    return triangulate(points, profile.contours);
}

}  // namespace whittle
