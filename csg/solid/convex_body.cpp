#include "csg/solid/convex_body.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/convex_hull.h"
#include "csg/solid/convex_parts.h"
#include "csg/solid/facets.h"

namespace whittle {
namespace {

// Of the body's size: what lies so near to a plane lies in it, up to the roundings of its placement.
constexpr double kFlatRounding = 0x1p-44;
// Sine of the angle below which two directions are one.
constexpr double kSameDirection = 0x1p-40;

BallImage ball(double r) { return {{r, 0, 0}, {0, r, 0}, {0, 0, r}}; }
BallImage disc(double r) { return {{r, 0, 0}, {0, r, 0}, {0, 0, 0}}; }

// Its columns, those that are not 0 first; nothing where all are.
std::optional<BallImage> tidied(const BallImage& image) {
    std::array<Vec3, 3> columns{image.u, image.v, image.w};
    std::stable_partition(columns.begin(), columns.end(), [](const Vec3& c) { return c != Vec3(0); });
    if (columns[0] == Vec3(0)) return std::nullopt;
    return BallImage{columns[0], columns[1], columns[2]};
}

ConvexPart placed(const ConvexPart& part, const Placement& at) {
    ConvexPart out{apply_to_point(at, part.centre), {}};
    for (const BallImage& i : part.images)
        if (const auto image = tidied({apply_to_direction(at, i.u), apply_to_direction(at, i.v), apply_to_direction(at, i.w)})) out.images.push_back(*image);
    return out;
}

// The parts of one shape, in its own frame; false where it has none.
struct PartsOf {
    const Solid& solid;
    NodeId node;
    ConvexParts& out;

    bool corner(const Vec3& p) {
        out.push_back({p, {}});
        return true;
    }
    bool rounded(const Vec3& centre, const BallImage& image) {
        out.push_back({centre, {image}});
        return true;
    }
    bool ring(double r, double z) { return r > 0 ? rounded({0, 0, z}, disc(r)) : corner({0, 0, z}); }
    bool facets() {
        const auto list = facets_of(solid, node);
        if (!list) return false;
        for (const Vec3& p : list->points) corner(p);
        return true;
    }
    std::optional<ConvexParts> profile(NodeId id) const {
        Use use;
        use.node = id;
        return convex_parts_of(solid, use);
    }

    bool operator()(const shape::Box& s) {
        for (int i = 0; i < 8; ++i) corner({i & 1 ? s.hi.x : s.lo.x, i & 2 ? s.hi.y : s.lo.y, i & 4 ? s.hi.z : s.lo.z});
        return true;
    }
    bool operator()(const shape::Ellipsoid& s) { return rounded(Vec3(0), {{s.radii.x, 0, 0}, {0, s.radii.y, 0}, {0, 0, s.radii.z}}); }
    bool operator()(const shape::Frustum& s) { return ring(s.r0, s.z0) && ring(s.r1, s.z1); }
    bool operator()(const shape::Torus& s) {
        out.push_back({Vec3(0), {disc(s.major), ball(s.minor)}});
        return true;
    }
    bool operator()(const shape::Capsule& s) { return rounded(s.p, ball(s.r)) && rounded(s.q, ball(s.r)); }
    bool operator()(const shape::RoundBox& s) {
        const std::size_t first = out.size();
        (*this)(shape::Box{s.lo + s.r, s.hi - s.r});
        if (s.r > 0)
            for (std::size_t i = first; i < out.size(); ++i) out[i].images.push_back(ball(s.r));
        return true;
    }
    bool operator()(const shape::ConvexBody& s) {
        out.insert(out.end(), s.hull->parts.begin(), s.hull->parts.end());
        return true;
    }
    bool operator()(const shape::FacetedBall&) { return facets(); }
    bool operator()(const shape::FacetedFrustum&) { return facets(); }
    bool operator()(const shape::Polyhedron& s) {
        for (const Vec3& p : s.mesh->points) corner(p);
        return true;
    }
    bool operator()(const shape::Extrusion& s) {
        if (s.slices > 0) return facets();
        const auto flat = s.twist_deg == 0 ? profile(s.profile) : std::nullopt;
        if (!flat) return false;
        for (const ConvexPart& part : *flat) {
            out.push_back(placed(part, Placement::translation({0, 0, s.z0})));
            out.push_back(placed(part, {{s.scale_top.x, 0, 0, 0, 0, s.scale_top.y, 0, 0, 0, 0, 0, s.z1}}));
        }
        return true;
    }
    // Corners turn to discs, discs to a disc and a ball.
    bool operator()(const shape::Revolution& s) {
        if (s.fragments > 0) return facets();
        const auto flat = s.angle_deg >= 360 ? profile(s.profile) : std::nullopt;
        if (!flat) return false;
        for (const ConvexPart& part : *flat) {
            ConvexPart turned{{0, 0, part.centre.y}, {}};
            if (part.centre.x != 0) turned.images.push_back(disc(std::fabs(part.centre.x)));
            for (const BallImage& image : part.images) {
                const auto r = similarity_of({{image.u.x, image.v.x, 0, 0, image.u.y, image.v.y, 0, 0, 0, 0, 1, 0}}, true);
                if (!r || image.w != Vec3(0)) return false;
                turned.images.push_back(ball(*r));
            }
            out.push_back(std::move(turned));
        }
        return true;
    }
    bool operator()(const shape::Disc& s) { return ring(s.r, 0); }
    bool operator()(const shape::Rectangle& s) {
        for (const Vec2 p : {s.lo, Vec2(s.hi.x, s.lo.y), s.hi, Vec2(s.lo.x, s.hi.y)}) corner({p.x, p.y, 0});
        return true;
    }
    bool operator()(const shape::Polygon& s) {
        if (s.section != kEmptyNode) return false;
        for (const auto& contour : *s.contours)
            for (const Vec2& p : contour) corner({p.x, p.y, 0});
        return true;
    }
    bool operator()(const auto&) { return false; }
};

bool collect(const Solid& solid, const Use& use, const Placement& above, ConvexParts& out) {
    if (use.motion != 0) return false;
    const Placement at = above * use.placement;
    const Node& node = solid.node(use.node);
    if (const auto* shape = std::get_if<Shape>(&node)) {
        ConvexParts own;
        if (!std::visit(PartsOf{solid, use.node, own}, *shape)) return false;
        for (const ConvexPart& part : own) out.push_back(placed(part, at));
        return true;
    }
    const auto& c = std::get<Combination>(node);
    return c.op == SetOp::kUnion && std::all_of(c.operands.begin(), c.operands.end(), [&](const Use& part) { return collect(solid, part, at, out); });
}

// The directions that a plane may stand across with a face in it.
std::vector<Vec3> candidates(const ConvexParts& parts) {
    std::vector<Vec3> out{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    const auto add = [&](const Vec3& across) {
        const double length = glm::length(across);
        if (!(length > 0)) return;
        const Vec3 n = across / length;
        const auto is_same = [&](const Vec3& m) { return glm::dot(m, n) > 0 && glm::length(glm::cross(m, n)) <= kSameDirection; };
        if (std::none_of(out.begin(), out.end(), is_same)) out.push_back(n);
    };
    std::vector<Vec3> centres;
    for (const ConvexPart& part : parts) {
        centres.push_back(part.centre);
        for (const BallImage& image : part.images)
            if (image.w == Vec3(0)) add(glm::cross(image.u, image.v)), add(glm::cross(image.v, image.u));
    }
    if (const auto hull = convex_hull_of(centres))
        for (const auto& f : hull->facets) add(glm::cross(hull->points[f[1]] - hull->points[f[0]], hull->points[f[2]] - hull->points[f[0]]));
    return out;
}

// Along a direction with these components, from the image's middle.
Vec3 farthest_of(const BallImage& image, const Vec3& c) {
    const double length = glm::length(c);
    return length > 0 ? (c.x / length) * image.u + (c.y / length) * image.v + (c.z / length) * image.w : Vec3(0);
}

// The middle of what the part has farthest along n; images that lie across n are added to `ways`.
Vec3 middle_of_farthest(const ConvexPart& part, const Vec3& n, double rounding, std::vector<Vec3>& ways) {
    ConvexPart pointed{part.centre, {}};
    for (const BallImage& image : part.images) {
        if (glm::length(components(image, n)) <= rounding) ways.insert(ways.end(), {image.u, image.v, image.w});
        else pointed.images.push_back(image);
    }
    return farthest_point(pointed, n);
}

// Where the parts that reach farthest along n span more than a line.
std::optional<FlatFace> face_along(const ConvexParts& parts, const Vec3& n, double size) {
    const double d = reach(parts, n), rounding = kFlatRounding * size;
    std::vector<Vec3> ways, middles;
    for (const ConvexPart& part : parts) {
        if (reach(part, n) < d - rounding) continue;
        middles.push_back(middle_of_farthest(part, n, rounding, ways));
        ways.push_back(middles.back() - middles.front());
    }
    const auto longest = std::max_element(ways.begin(), ways.end(), [](const Vec3& a, const Vec3& b) { return glm::dot(a, a) < glm::dot(b, b); });
    const auto is_across = [&](const Vec3& w) { return glm::length(glm::cross(*longest, w)) > kSameDirection * size * glm::length(*longest); };
    if (std::none_of(ways.begin(), ways.end(), is_across)) return std::nullopt;
    Vec3 sum(0);
    for (const Vec3& m : middles) sum += m;
    return FlatFace{n, d, sum / static_cast<double>(middles.size())};
}

}  // namespace

double reach(const ConvexPart& part, const Vec3& n) {
    double d = glm::dot(n, part.centre);
    for (const BallImage& image : part.images) d += glm::length(components(image, n));
    return d;
}

Vec3 farthest_point(const ConvexPart& part, const Vec3& n) {
    Vec3 p = part.centre;
    for (const BallImage& image : part.images) p += farthest_of(image, components(image, n));
    return p;
}

double reach(const ConvexParts& parts, const Vec3& n) {
    double d = -HUGE_VAL;
    for (const ConvexPart& part : parts) d = std::max(d, reach(part, n));
    return d;
}

const ConvexPart& farthest_part(const ConvexParts& parts, const Vec3& n) {
    const ConvexPart* best = &parts.front();
    double most = -HUGE_VAL;
    for (const ConvexPart& part : parts)
        if (const double d = reach(part, n); d > most) best = &part, most = d;
    return *best;
}

Vec3 farthest_point(const ConvexParts& parts, const Vec3& n) { return farthest_point(farthest_part(parts, n), n); }

Vec3 farthest_point(const ConvexParts& parts, double size, const FlatFace& face, const Vec3& way) {
    const double rounding = kFlatRounding * size;
    Vec3 best = face.middle;
    for (const ConvexPart& part : parts) {
        if (reach(part, face.n) < face.d - rounding) continue;
        Vec3 p = part.centre;
        for (const BallImage& image : part.images) {
            const Vec3 up = components(image, face.n);
            p += farthest_of(image, glm::length(up) <= rounding ? components(image, way) : up);
        }
        if (glm::dot(way, p) > glm::dot(way, best)) best = p;
    }
    return best;
}

// A mean with weights that are positive lies inside whatever the parts are.
Vec3 middle_of(const ConvexParts& parts) {
    Vec3 sum(0);
    for (const ConvexPart& part : parts) sum += part.centre;
    return sum / static_cast<double>(parts.size());
}

double size_of(const ConvexParts& parts, const Vec3& middle) {
    double size = 0;
    for (const ConvexPart& part : parts) {
        double r = glm::distance(part.centre, middle);
        for (const BallImage& i : part.images) r += std::sqrt(glm::dot(i.u, i.u) + glm::dot(i.v, i.v) + glm::dot(i.w, i.w));
        size = std::max(size, r);
    }
    return size;
}

std::optional<ConvexParts> convex_parts_of(const Solid& solid, const Use& use) {
    ConvexParts out;
    if (!collect(solid, use, {}, out)) return std::nullopt;
    return out;
}

ConvexParts sums_of(const ConvexParts& a, const ConvexParts& b) {
    ConvexParts out;
    out.reserve(a.size() * b.size());
    for (const ConvexPart& p : a)
        for (const ConvexPart& q : b) {
            ConvexPart& sum = out.emplace_back(ConvexPart{p.centre + q.centre, p.images});
            sum.images.insert(sum.images.end(), q.images.begin(), q.images.end());
        }
    return out;
}

ConvexParts without_hidden_parts(ConvexParts parts) {
    std::vector<Vec3> corners;
    ConvexParts out;
    for (ConvexPart& part : parts) {
        if (part.images.empty()) corners.push_back(part.centre);
        else if (std::find(out.begin(), out.end(), part) == out.end()) out.push_back(std::move(part));
    }
    if (const auto hull = convex_hull_of(corners)) corners = hull->points;
    for (const Vec3& p : corners)
        if (ConvexPart corner{p, {}}; std::find(out.begin(), out.end(), corner) == out.end()) out.push_back(std::move(corner));
    return out;
}

std::vector<FlatFace> flat_faces(const ConvexParts& parts) {
    const double size = size_of(parts, middle_of(parts));
    std::vector<FlatFace> out;
    for (const Vec3& n : candidates(parts))
        if (const auto face = face_along(parts, n, size)) out.push_back(*face);
    return out;
}

namespace {

// 0 for -0, so that equal bodies are equal numbers.
ConvexParts without_negative_zeros(ConvexParts parts) {
    for (ConvexPart& part : parts) {
        part.centre += Vec3(0.0);
        for (BallImage& i : part.images) i.u += Vec3(0.0), i.v += Vec3(0.0), i.w += Vec3(0.0);
    }
    return parts;
}

}  // namespace

ConvexHullBody::ConvexHullBody(ConvexParts all)
    : parts(without_negative_zeros(std::move(all))), middle(middle_of(parts)), size(size_of(parts, middle)), faces(flat_faces(parts)) {}

bool shape::ConvexBody::operator==(const ConvexBody& o) const { return hull == o.hull || hull->parts == o.hull->parts; }

}  // namespace whittle
