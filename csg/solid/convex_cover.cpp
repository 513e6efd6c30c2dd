#include "csg/solid/convex_cover.h"

#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/convex_hull.h"
#include "csg/solid/ear_clipping.h"
#include "csg/solid/polytope.h"
#include "csg/solid/profile.h"
#include "csg/solid/use_of.h"

namespace whittle {
namespace {

// Corners of one piece beyond which its sums would cost more than a mesh of the whole.
constexpr std::size_t kMostCorners = 4000;
// Of a set's size: what is thinner is a rounding of cutting it.
constexpr double kSlack = 0x1p-40;
// Sums of corners of two hulls that are made without asking which of them can be corners.
constexpr std::size_t kFewSums = 4096;
// Of a set's size: by how much corners of one face differ in height.
constexpr double kFaceSlack = 0x1p-36;
constexpr int kLeastChords = 8, kMostChords = 360;
constexpr double kPi = 3.14159265358979323846;

// Chords of a whole circle whose arcs rise above them by the tolerance at most, a multiple of four.
int chords_of(double radius, double tolerance) {
    const double share = tolerance / radius;
    const double n = share < 1 ? std::ceil(kPi / std::acos(1 - share)) : kLeastChords;
    return (static_cast<int>(std::clamp(n, static_cast<double>(kLeastChords), static_cast<double>(kMostChords))) + 3) / 4 * 4;
}

// Points of the image of the unit ball, disc or segment.
std::vector<Vec3> points_of(const BallImage& image, double tolerance) {
    const double radius = std::max({glm::length(image.u), glm::length(image.v), glm::length(image.w)});
    if (image.v == Vec3(0) && image.w == Vec3(0)) return {image.u, -image.u};
    std::vector<Vec3> out;
    const int n = chords_of(radius, tolerance);
    const auto ring = [&](double share, const Vec3& middle) {
        for (int i = 0; i < n; ++i) out.push_back(middle + share * (cosd(360.0 * i / n) * image.u + sind(360.0 * i / n) * image.v));
    };
    if (image.w == Vec3(0)) {
        ring(1, Vec3(0));
        return out;
    }
    out = {image.w, -image.w};
    for (int j = 1; j < n / 2; ++j) ring(sind(360.0 * j / n), cosd(360.0 * j / n) * image.w);
    return out;
}

class Coverer {
public:
    Coverer(SolidBuilder& builder, const CoverOptions& options) : builder_(builder), options_(options) {}

    std::optional<std::vector<Use>> cover(const Use& use) {
        if (use.motion != 0) return std::nullopt;
        if (use.node == kEmptyNode) return std::vector<Use>{};
        if (options_.is_convex(use)) return std::vector<Use>{bare(use)};
        const Node node = builder_.node(use.node);
        std::optional<std::vector<Use>> own;
        if (const auto* c = std::get_if<Combination>(&node)) {
            own = c->op == SetOp::kUnion ? united(*c) : cut(*c);
        } else {
            own = std::visit([&](const auto& shape) { return cover_shape(use.node, shape); }, std::get<Shape>(node));
        }
        if (!own || own->size() > options_.most) return std::nullopt;
        for (Use& piece : *own) piece = bare(builder_.placed(use.placement, piece));
        return own;
    }

    bool chords = false;

private:
    SolidBuilder& builder_;
    const CoverOptions& options_;

    static Use bare(Use use) {
        use.label = kNoLabel;
        return use;
    }

    std::optional<std::vector<Use>> united(const Combination& c) {
        std::vector<Use> out;
        for (const Use& operand : c.operands) {
            auto own = cover(operand);
            if (!own || out.size() + own->size() > options_.most) return std::nullopt;
            out.insert(out.end(), own->begin(), own->end());
        }
        return out;
    }

    std::optional<std::vector<Polytope>> polytopes(const Use& use) {
        const auto pieces = cover(use);
        if (!pieces) return std::nullopt;
        std::vector<Polytope> out;
        for (const Use& piece : *pieces) {
            const auto parts = convex_parts_of(builder_.so_far(), piece);
            if (!parts) return std::nullopt;
            chords |= std::any_of(parts->begin(), parts->end(), [](const ConvexPart& part) { return !part.images.empty(); });
            auto corners = corners_within(*parts, options_.tolerance, kMostCorners);
            if (!corners) return std::nullopt;
            if (auto made = polytope_of(std::move(*corners)); !made.empty()) out.push_back(std::move(made));
        }
        return out;
    }

    // Pieces of the first operand, cut by those of each of the others.
    std::optional<std::vector<Use>> cut(const Combination& c) {
        auto kept = polytopes(c.operands[0]);
        if (!kept) return std::nullopt;
        double size = 0;
        for (const Polytope& p : *kept)
            for (const Vec3& corner : corners_of(p)) size = std::max(size, glm::length(corner));
        for (std::size_t i = 1; i < c.operands.size(); ++i) {
            const auto others = polytopes(c.operands[i]);
            if (!others) return std::nullopt;
            kept = c.op == SetOp::kDifference ? less(std::move(*kept), *others, kSlack * size) : met(*kept, *others, kSlack * size);
            if (!kept) return std::nullopt;
        }
        return solids(*kept);
    }

    std::optional<std::vector<Polytope>> less(std::vector<Polytope> kept, const std::vector<Polytope>& cutters, double slack) const {
        for (const Polytope& cutter : cutters) {
            const auto planes = planes_of(cutter);
            std::vector<Polytope> next;
            for (const Polytope& p : kept) {
                auto pieces = difference(p, planes, slack);
                if (next.size() + pieces.size() > options_.most) return std::nullopt;
                std::move(pieces.begin(), pieces.end(), std::back_inserter(next));
            }
            kept = std::move(next);
        }
        return kept;
    }

    std::optional<std::vector<Polytope>> met(const std::vector<Polytope>& a, const std::vector<Polytope>& b, double slack) const {
        if (a.size() * b.size() > options_.most) return std::nullopt;
        std::vector<Polytope> out;
        for (const Polytope& q : b) {
            const auto planes = planes_of(q);
            for (Polytope rest : a) {
                for (const Plane& plane : planes) rest = clipped(rest, plane, slack);
                if (!rest.empty()) out.push_back(std::move(rest));
            }
        }
        return out;
    }

    std::vector<Use> solids(const std::vector<Polytope>& polytopes) {
        std::vector<Use> out;
        for (const Polytope& p : polytopes) add_hull(out, corners_of(p));
        return out;
    }

    void add_hull(std::vector<Use>& out, std::vector<Vec3> corners) {
        if (auto hull = convex_hull_of(std::move(corners))) out.push_back(use_of(builder_.shape(shape::Polyhedron{std::make_shared<const FacetList>(std::move(*hull))})));
    }

    // Balls along the ring, two and two.
    std::optional<std::vector<Use>> cover_shape(NodeId, const shape::Torus& s) {
        if (s.minor > s.major) return std::nullopt;
        chords = true;
        const int n = chords_of(s.major, options_.tolerance);
        const auto place = [&](int i) { return Vec3(s.major * cosd(360.0 * (i % n) / n), s.major * sind(360.0 * (i % n) / n), 0); };
        std::vector<Use> out;
        for (int i = 0; i < n; ++i) out.push_back(use_of(builder_.shape(shape::Capsule{place(i), place(i + 1), s.minor})));
        return out;
    }

    // The profile as convex polygons.
    std::optional<std::vector<std::vector<Vec2>>> flat_pieces(NodeId profile, bool sides_stay) {
        const Bounds box = builder_.bounds(profile);
        const double size = glm::length(box.hi - box.lo);
        const Contours contours = contours_of(builder_.so_far(), profile, sides_stay ? kProfileTolerance * size : options_.tolerance);
        std::vector<Vec2> points;
        std::vector<std::vector<std::uint32_t>> rings;
        for (const auto& contour : contours) {
            auto& ring = rings.emplace_back();
            for (const Vec2& p : contour) {
                ring.push_back(static_cast<std::uint32_t>(points.size()));
                points.push_back(p);
            }
        }
        if (contours.size() == 1)
            if (auto hull = convex_hull_of(contours[0]); hull.size() == contours[0].size()) return std::vector<std::vector<Vec2>>{std::move(hull)};
        const auto triangles = ear_clipped(points, rings);
        if (!triangles) return std::nullopt;
        return merged(points, *triangles);
    }

    // Triangles joined to convex polygons along the sides they share, as long as that goes.
    // Source: Hertel, Mehlhorn, Fast Triangulation of Simple Polygons (1983).
    static std::vector<std::vector<Vec2>> merged(const std::vector<Vec2>& points, const std::vector<IndexTriangle>& triangles) {
        std::vector<std::vector<Vec2>> out;
        for (const auto& t : triangles) {
            std::vector<Vec2> ring{points[t[0]], points[t[1]], points[t[2]]};
            bool joined = false;
            for (auto& other : out) joined = joined || join(other, ring);
            if (!joined) out.push_back(std::move(ring));
        }
        return out;
    }

    static bool join(std::vector<Vec2>& a, const std::vector<Vec2>& b) {
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t j = 0; j < b.size(); ++j) {
                if (a[i] != b[(j + 1) % b.size()] || a[(i + 1) % a.size()] != b[j]) continue;
                std::vector<Vec2> both = a;
                both.insert(both.end(), b.begin(), b.end());
                // Convex where no corner is lost but the two that were there twice.
                std::vector<Vec2> hull = convex_hull_of(std::move(both));
                if (hull.size() != a.size() + b.size() - 2) return false;
                a = std::move(hull);
                return true;
            }
        return false;
    }

    std::optional<std::vector<Use>> cover_shape(NodeId, const shape::Extrusion& s) {
        if (s.twist_deg != 0 || s.scale_top.x != s.scale_top.y) return std::nullopt;
        const auto pieces = flat_pieces(s.profile, is_straight(s.profile));
        if (!pieces) return std::nullopt;
        chords |= !is_straight(s.profile);
        std::vector<Use> out;
        for (const auto& ring : *pieces) {
            std::vector<Vec3> corners;
            for (const Vec2& p : ring) {
                corners.emplace_back(p, s.z0);
                corners.emplace_back(p * s.scale_top, s.z1);
            }
            add_hull(out, std::move(corners));
        }
        return out;
    }

    bool is_straight(NodeId id) const {
        if (const auto* s = std::get_if<Shape>(&builder_.node(id))) return !is_curved_2d(*s);
        const auto& operands = std::get<Combination>(builder_.node(id)).operands;
        return std::all_of(operands.begin(), operands.end(), [&](const Use& use) { return is_straight(use.node); });
    }

    // Wedges between two places of the profile.
    std::optional<std::vector<Use>> cover_shape(NodeId node, const shape::Revolution& s) {
        if (builder_.bounds(s.profile).lo.x < 0) return std::nullopt;
        const auto pieces = flat_pieces(s.profile, s.fragments > 0 && is_straight(s.profile));
        if (!pieces) return std::nullopt;
        chords |= s.fragments == 0;
        const double radius = builder_.bounds(node).hi.x;
        const int n = s.fragments > 0 ? s.fragments : std::max(2, static_cast<int>(std::ceil(chords_of(radius, options_.tolerance) * s.angle_deg / 360)));
        if (pieces->size() * static_cast<std::size_t>(n) > options_.most) return std::nullopt;
        std::vector<Use> out;
        for (const auto& ring : *pieces)
            for (int i = 0; i < n; ++i) {
                std::vector<Vec3> corners;
                for (const int j : {i, i + 1}) {
                    const double at = s.angle_deg == 360 ? s.start_deg + 360.0 * (j % n) / n : s.start_deg + s.angle_deg * j / n;
                    for (const Vec2& p : ring) corners.emplace_back(p.x * cosd(at), p.x * sind(at), p.y);
                }
                add_hull(out, std::move(corners));
            }
        return out;
    }

    std::optional<std::vector<Use>> cover_shape(NodeId, const auto&) { return std::nullopt; }
};

std::vector<Vec3> normals_of(const FacetList& hull) {
    std::vector<Vec3> out;
    for (const auto& f : hull.facets) {
        const Vec3 n = glm::cross(hull.points[f[1]] - hull.points[f[0]], hull.points[f[2]] - hull.points[f[0]]);
        if (glm::length(n) > 0) out.push_back(glm::normalize(n));
    }
    return out;
}

// Those that reach farthest along n, but for roundings.
std::vector<Vec3> farthest_of(const std::vector<Vec3>& points, const Vec3& n, double slack) {
    double most = -HUGE_VAL;
    for (const Vec3& p : points) most = std::max(most, glm::dot(p, n));
    std::vector<Vec3> out;
    for (const Vec3& p : points)
        if (glm::dot(p, n) >= most - slack) out.push_back(p);
    return out;
}

double farthest_coordinate(const std::vector<Vec3>& points) {
    double size = 0;
    for (const Vec3& p : points) size = std::max(size, glm::length(p));
    return size;
}

}  // namespace

std::optional<FacetList> sum_of_hulls(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    const auto left = a.size() * b.size() > kFewSums ? convex_hull_of(a) : std::nullopt, right = left ? convex_hull_of(b) : std::nullopt;
    if (!right || left->points.size() * right->points.size() <= kFewSums) return convex_hull_of(sums_of(right ? left->points : a, right ? right->points : b));
    const double slack = kFaceSlack * (farthest_coordinate(left->points) + farthest_coordinate(right->points));
    std::vector<Vec3> sums;
    for (const FacetList* hull : {&*left, &*right})
        for (const Vec3& n : normals_of(*hull)) {
            const auto here = sums_of(farthest_of(left->points, n, slack), farthest_of(right->points, n, slack));
            sums.insert(sums.end(), here.begin(), here.end());
        }
    return convex_hull_of(std::move(sums));
}

std::optional<std::vector<Vec3>> corners_within(const ConvexParts& parts, double tolerance, std::size_t most) {
    std::vector<Vec3> out;
    for (const ConvexPart& part : parts) {
        std::vector<Vec3> own{part.centre};
        for (const BallImage& image : part.images) {
            own = sums_of(own, points_of(image, tolerance));
            if (own.size() > most) return std::nullopt;
        }
        out.insert(out.end(), own.begin(), own.end());
        if (out.size() > most) return std::nullopt;
    }
    return out;
}

std::optional<ConvexCover> convex_cover(SolidBuilder& builder, const Use& use, const CoverOptions& options) {
    Coverer coverer(builder, options);
    auto pieces = coverer.cover(use);
    if (!pieces) return std::nullopt;
    return ConvexCover{std::move(*pieces), coverer.chords};
}

}  // namespace whittle
