#include "csg/solid/profile.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <polyclipping/clipper.hpp>

#include "csg/base/degrees.h"
#include "csg/solid/clean_paths.h"
#include "csg/solid/parabola.h"

namespace whittle {
namespace {

using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;
using Long = long double;

// Bits of a coordinate on the grid: Clipper takes up to 62.
constexpr int kGridBits = 44;
// Of the grid for corners that carry rounding, and how many of its units two of them may be apart.
constexpr int kRoundedBits = 32;
constexpr double kSameCorner = 4;
constexpr int kFewestChords = 8;
constexpr int kMostChords = 1 << 16;
constexpr double kPi = 3.14159265358979323846;

// OpenSCAD's limit on how far a mitered corner may reach, in deltas.
constexpr double kMiterLimit = 1e6;

double scale_for(double size) { return std::isfinite(size) ? std::ldexp(1.0, kGridBits - (size > 0 ? std::ilogb(size) : 0)) : 0; }

int chords_of_circle(double r, double tolerance) {
    if (!(tolerance < r)) return kFewestChords;
    const double n = std::ceil(kPi / std::acos(1 - tolerance / r));
    return 4 * static_cast<int>(std::ceil(std::clamp(n, 1.0 * kFewestChords, 1.0 * kMostChords) / 4));
}

// How much a placement lengthens in the plane, at most.
double stretch(const Placement& a) { return std::sqrt(a.m[0] * a.m[0] + a.m[1] * a.m[1] + a.m[4] * a.m[4] + a.m[5] * a.m[5]); }

class Clipping {
public:
    Clipping(const Solid& solid, NodeId root, double tolerance) : solid_(solid), tolerance_(tolerance) {
        scale_ = scale_for(size_of(root, {}));
    }

    Paths of_node(NodeId node, const Placement& placement) {
        if (const auto* s = std::get_if<Shape>(&solid_.node(node))) return of_shape(*s, placement);
        const auto& c = std::get<Combination>(solid_.node(node));
        std::vector<Paths> parts;
        for (const Use& use : c.operands) parts.push_back(of_node(use.node, placement * use.placement));
        if (parts.empty()) return {};
        if (c.op == SetOp::kUnion) return united(parts, 0);
        Paths result = std::move(parts[0]);
        if (c.op == SetOp::kDifference) return parts.size() == 1 ? result : clipped(ClipperLib::ctDifference, result, united(parts, 1));
        for (std::size_t i = 1; i < parts.size(); ++i) result = clipped(ClipperLib::ctIntersection, result, parts[i]);
        return result;
    }

    bool is_finite() const { return std::isfinite(scale_) && scale_ > 0; }

    // Corners that were given keep their bits.
    RoundedContours contours(const Paths& paths) const {
        RoundedContours out;
        for (const Path& path : paths) {
            auto& contour = out.contours.emplace_back();
            for (const IntPoint& p : path) {
                const auto given = given_.find(p);
                const bool made = given == given_.end();
                contour.push_back(made ? Vec2(static_cast<double>(p.X) / scale_, static_cast<double>(p.Y) / scale_) : given->second.at);
                out.rounding = std::max(out.rounding, made ? 1 / scale_ : given->second.rounding);
            }
        }
        return out;
    }

private:
    struct Given {
        Vec2 at;
        double rounding = 0;  // of its placing
    };
    struct Hash {
        std::size_t operator()(const IntPoint& p) const { return static_cast<std::size_t>(p.X) * 0x9E3779B97F4A7C15u + static_cast<std::size_t>(p.Y); }
    };

    // The largest coordinate of any shape below the node: also of those that are cut away.
    double size_of(NodeId node, const Placement& placement) const {
        double size = 0;
        if (const auto* c = std::get_if<Combination>(&solid_.node(node))) {
            for (const Use& use : c->operands) size = std::max(size, size_of(use.node, placement * use.placement));
            return size;
        }
        const Bounds box = placed_bounds(solid_.bounds(node), placement);
        return std::max({std::fabs(box.lo.x), std::fabs(box.lo.y), std::fabs(box.hi.x), std::fabs(box.hi.y)});
    }

    Path path_of(const std::vector<Vec2>& points, const Placement& placement) {
        Path path;
        for (const Vec2& p : points) {
            const Vec3 q = apply_to_point(placement, {p.x, p.y, 0});
            const auto off = [&](int i) { return std::abs(static_cast<double>(placement.linear(i, 0) * Long(p.x) + placement.linear(i, 1) * Long(p.y) + placement.offset(i) - q[i])); };
            path.emplace_back(std::llround(q.x * scale_), std::llround(q.y * scale_));
            given_.emplace(path.back(), Given{Vec2(q.x, q.y), std::max(off(0), off(1))});
        }
        return path;
    }

    Paths of_shape(const Shape& s, const Placement& placement) {
        Paths paths;
        if (const auto* disc = std::get_if<shape::Disc>(&s)) {
            paths.push_back(path_of(circle_points(disc->r, chords_of_circle(disc->r, tolerance_ / stretch(placement))), placement));
        } else if (const auto* r = std::get_if<shape::Rectangle>(&s)) {
            paths.push_back(path_of({r->lo, {r->hi.x, r->lo.y}, r->hi, {r->lo.x, r->hi.y}}, placement));
        } else if (const auto* polygon = std::get_if<shape::Polygon>(&s)) {
            for (const auto& contour : *polygon->contours) paths.push_back(path_of(contour, placement));
        } else if (const auto* segment = std::get_if<shape::ParabolicSegment>(&s)) {
            paths.push_back(path_of(parabola_corners(*segment, parabola_chords(*segment, tolerance_ / stretch(placement))), placement));
        }
        return executed(ClipperLib::ctUnion, paths, {}, ClipperLib::pftEvenOdd);
    }

    static Paths united(const std::vector<Paths>& parts, std::size_t first) {
        if (parts.size() == first + 1) return parts[first];
        Paths all;
        for (std::size_t i = first; i < parts.size(); ++i) all.insert(all.end(), parts[i].begin(), parts[i].end());
        return executed(ClipperLib::ctUnion, all, {}, ClipperLib::pftNonZero);
    }
    static Paths clipped(ClipperLib::ClipType type, const Paths& subject, const Paths& clip) {
        return executed(type, subject, clip, ClipperLib::pftNonZero);
    }
    static Paths executed(ClipperLib::ClipType type, const Paths& subject, const Paths& clip, ClipperLib::PolyFillType fill) {
        ClipperLib::Clipper clipper;
        clipper.PreserveCollinear(true);
        clipper.StrictlySimple(true);
        clipper.AddPaths(subject, ClipperLib::ptSubject, true);
        clipper.AddPaths(clip, ClipperLib::ptClip, true);
        Paths result;
        clipper.Execute(type, result, fill, fill);
        return result;
    }

    const Solid& solid_;
    double tolerance_;
    double scale_;
    std::unordered_map<IntPoint, Given, Hash> given_;
};

}  // namespace

Contours contours_of(const Solid& solid, NodeId node, double tolerance) { return rounded_contours_of(solid, node, tolerance).contours; }

RoundedContours rounded_contours_of(const Solid& solid, NodeId node, double tolerance) {
    Clipping clipping(solid, node, tolerance);
    if (!clipping.is_finite()) return {};
    return clipping.contours(clean_paths(clipping.of_node(node, {})));
}

namespace {

double size_of(const std::vector<std::vector<Vec2>>& rings, double at_least) {
    double size = at_least;
    for (const auto& ring : rings)
        for (const Vec2& p : ring) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
    return size;
}

Paths on_grid(const std::vector<std::vector<Vec2>>& rings, double scale) {
    Paths paths;
    for (const auto& ring : rings) {
        Path& path = paths.emplace_back();
        for (const Vec2& p : ring) path.emplace_back(std::llround(p.x * scale), std::llround(p.y * scale));
    }
    return paths;
}

Contours off_grid(const Paths& paths, double scale) {
    Contours out;
    for (const Path& path : paths) {
        auto& contour = out.emplace_back();
        for (const IntPoint& p : path) contour.emplace_back(static_cast<double>(p.X) / scale, static_cast<double>(p.Y) / scale);
    }
    return out;
}

}  // namespace

Contours united_rings(const std::vector<std::vector<Vec2>>& rings) {
    const double scale = std::ldexp(scale_for(size_of(rings, 0)), kRoundedBits - kGridBits);
    if (!(scale > 0) || !std::isfinite(scale)) return {};
    const auto united = [](const Paths& paths) {
        ClipperLib::Clipper clipper;
        clipper.StrictlySimple(true);
        clipper.AddPaths(paths, ClipperLib::ptSubject, true);
        Paths result;
        clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftPositive, ClipperLib::pftPositive);
        return result;
    };
    const auto grown = [](const Paths& paths, double by) {
        ClipperLib::ClipperOffset offset;
        offset.AddPaths(paths, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
        Paths result;
        offset.Execute(result, by);
        return result;
    };
    Paths result = grown(grown(united(on_grid(rings, scale)), kSameCorner), -kSameCorner);
    ClipperLib::CleanPolygons(result, kSameCorner);
    return off_grid(united(result), scale);
}

Contours offset_contours(const Contours& contours, double delta, Join join, int fragments) {
    const double scale = scale_for(size_of(contours, std::fabs(delta)));
    if (!(scale > 0) || !std::isfinite(scale)) return {};
    const Paths paths = on_grid(contours, scale);
    const double arc_tolerance = std::fabs(delta) * (1 - cosd(180.0 / std::max(3, fragments)));
    ClipperLib::ClipperOffset offset(kMiterLimit, arc_tolerance * scale);
    const ClipperLib::JoinType type = join == Join::kRound ? ClipperLib::jtRound : join == Join::kMiter ? ClipperLib::jtMiter : ClipperLib::jtSquare;
    offset.AddPaths(paths, type, ClipperLib::etClosedPolygon);
    Paths result;
    offset.Execute(result, delta * scale);
    return off_grid(result, scale);
}

}  // namespace whittle
