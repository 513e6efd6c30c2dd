// lower_faceted.cpp — shapes of flat faces: n-gon balls, cones and cylinders and convex polygons as cells of planes; the rest counted by parity.
//
// Cells are defined by their planes, corners follow: so the snap may move a plane, and a ray asks only the few planes it can feel (facet_tree.h).
#include <algorithm>

#include "csg/base/degrees.h"
#include "csg/solid/facets.h"
#include "csg/solid/predicates.h"
#include "tracer/engine/formula_builder.h"

namespace whittle {

namespace {

constexpr double kMostPlanes = 1 << 16;         // of one cell
constexpr double kLeastOfWhole = 0x1p-30;       // rings thinner, or closer, than this share of the shape are left to the mesh
constexpr double kBeyondCorners = 0x1p-48;      // of the size, for each corner of a ring: where planes meet, their roundings grow by the angle's inverse

struct Ring {
    double r = 0, z = 0;
};

std::vector<Ring> rings_of(const shape::FacetedBall& s) {
    std::vector<Ring> rings;
    const int count = (s.n + 1) / 2;
    if (static_cast<double>(count) * s.n > kMostPlanes) return rings;
    for (int i = count - 1; i >= 0; --i) {
        const double phi = 180.0 * (i + 0.5) / count;
        rings.push_back({s.r * sind(phi), s.r * cosd(phi)});
    }
    return rings;
}

std::vector<Ring> rings_of(const shape::FacetedFrustum& s) {
    if (s.n > kMostPlanes) return {};
    return {{s.r0, s.z0}, {s.r1, s.z1}};
}

// Can planes through the rings' corners be told apart well?
bool are_plain(const std::vector<Ring>& rings, int n) {
    if (rings.size() < 2 || n < 3) return false;
    double size = 0;
    for (const Ring& r : rings) size = std::max({size, r.r, std::abs(r.z)});
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
        const double wide = std::max(rings[i].r, rings[i + 1].r);
        if (!(wide > kLeastOfWhole * n * size) || !(rings[i + 1].z - rings[i].z > kLeastOfWhole * size)) return false;
    }
    return std::isfinite(size) && size > 0x1p-200 && size < 0x1p200;
}

// Without corners that lie on the line between their neighbours; empty unless what is left turns left everywhere, once around.
std::vector<Vec2> as_convex(std::vector<Vec2> contour) {
    contour.erase(std::unique(contour.begin(), contour.end()), contour.end());
    while (contour.size() > 1 && contour.front() == contour.back()) contour.pop_back();
    const auto doubled_area = [](const std::vector<Vec2>& c) {
        double area = 0;
        for (std::size_t i = 0; i < c.size(); ++i) {
            const Vec2 a = c[i] - c[0], b = c[(i + 1) % c.size()] - c[0];
            area += a.x * b.y - b.x * a.y;
        }
        return area;
    };
    if (contour.size() < 3) return {};
    if (doubled_area(contour) < 0) std::reverse(contour.begin(), contour.end());
    std::vector<Vec2> kept;
    const std::size_t n = contour.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn_of(contour[(i + n - 1) % n], contour[i], contour[(i + 1) % n]) != 0) kept.push_back(contour[i]);
    const std::size_t m = kept.size();
    if (m < 3) return {};
    const auto rises = [&](std::size_t i) {
        const Vec2 a = kept[i % m], b = kept[(i + 1) % m];
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    };
    int changes = 0;
    for (std::size_t i = 0; i < m; ++i) {
        if (turn_of(kept[i], kept[(i + 1) % m], kept[(i + 2) % m]) <= 0) return {};
        changes += rises(i) != rises(i + 1);
    }
    return changes == 2 ? kept : std::vector<Vec2>{};
}

}  // namespace

template <class S>
FormulaId FormulaBuilder::of_belts(const S& s, const Site& site) {
    const std::vector<Ring> rings = rings_of(s);
    if (!are_plain(rings, s.n)) return kNoFormula;
    double r = 0;
    for (const Ring& ring : rings) r = std::max(r, ring.r);
    const Ring &low = rings.front(), &high = rings.back();
    Placer p(out_, site.chain, site.motion, {Vec3(-r, -r, low.z), Vec3(r, r, high.z)}, Absorb::kAny);
    std::vector<HalfSpaceRef> sides;
    if (low.r > 0) sides.push_back(p.axis_plane(2, low.z, false));
    if (high.r > 0) sides.push_back(p.axis_plane(2, high.z, true));
    for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
        const Ring &a = rings[i], &b = rings[i + 1];
        // Through an edge of the wider ring and a corner of the other one.
        const bool up = a.r >= b.r;
        const Ring &wide = up ? a : b, &narrow = up ? b : a;
        const std::vector<Vec2> edge = circle_points(wide.r, s.n), corner = circle_points(narrow.r, s.n);
        for (std::size_t k = 0; k < edge.size(); ++k) {
            const Vec2 from = edge[k], to = edge[(k + 1) % edge.size()];
            if (a.r == b.r) {
                sides.push_back(p.upright_side(from, to));
            } else {
                sides.push_back(p.side(Vec3(up ? from : to, wide.z), Vec3(up ? to : from, wide.z), Vec3(corner[k], narrow.z)));
            }
        }
    }
    Bounds box = p.root_box();
    const double room = kBeyondCorners * s.n * std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
    box.lo -= room;
    box.hi += room;
    return cell(std::move(sides), box, site);
}

template FormulaId FormulaBuilder::of_belts(const shape::FacetedBall& s, const Site& site);
template FormulaId FormulaBuilder::of_belts(const shape::FacetedFrustum& s, const Site& site);

FormulaId FormulaBuilder::prism(const std::vector<std::vector<Vec2>>& contours, const Site& site) {
    Vec2 lo(HUGE_VAL), hi(-HUGE_VAL);
    for (const auto& contour : contours)
        for (const Vec2& v : contour) lo = glm::min(lo, v), hi = glm::max(hi, v);
    Placer p(out_, site.chain, site.motion, swept(lo, hi, site), Absorb::kAny);
    if (contours.size() == 1) {
        std::vector<Vec2> corners;
        const int axis = p.axis_of(2);
        for (const Vec2& at : contours[0]) {
            const Vec3 q = p.point(Vec3(at, 0));
            corners.emplace_back(q[(axis + 1) % 3], q[(axis + 2) % 3]);
        }
        std::vector<HalfSpaceRef> sides;
        corners = as_convex(std::move(corners));
        for (std::size_t i = 0; i < corners.size(); ++i) sides.push_back(p.edge_side(axis, corners[i], corners[(i + 1) % corners.size()]));
        if (!sides.empty()) return cell(std::move(sides), everywhere(), site);
    }
    PrismData data;
    data.frame = p.frame();
    data.axis = static_cast<std::uint8_t>(p.axis_of(2));
    const int u = (data.axis + 1) % 3, v = (data.axis + 2) % 3;
    for (const auto& contour : contours) {
        std::vector<Vec2> moved;
        for (const Vec2& at : contour) {
            const Vec3 q = p.point(Vec3(at, 0));
            moved.emplace_back(q[u], q[v]);
        }
        for (std::size_t i = 0; i < moved.size(); ++i) data.edges.push_back(p.edge_plane(data.axis, moved[i], moved[(i + 1) % moved.size()]));
        data.contours.push_back(std::move(moved));
    }
    FormulaNode n = leaf(FormulaKind::kPrism, p.root_box(), site);
    n.data = static_cast<std::uint32_t>(out_.prisms.size());
    out_.prisms.push_back(std::move(data));
    return push(std::move(n));
}

bool FormulaBuilder::has_flat_faces(NodeId id) const {
    const Node& n = solid_.node(id);
    if (const auto* c = std::get_if<Combination>(&n))
        return std::all_of(c->operands.begin(), c->operands.end(), [&](const Use& u) { return has_flat_faces(u.node); });
    const Shape& s = std::get<Shape>(n);
    if (const auto* e = std::get_if<shape::Extrusion>(&s))
        return (e->slices > 0 || (e->twist_deg == 0 && e->scale_top.x == e->scale_top.y)) && has_flat_faces(e->profile);
    if (const auto* r = std::get_if<shape::Revolution>(&s)) return r->fragments > 0 && has_flat_faces(r->profile);
    return !is_curved_2d(s);
}

FormulaId FormulaBuilder::faceted(NodeId id, const Site& site) {
    Placer p(out_, site.chain, site.motion, solid_.bounds(id), Absorb::kExact);
    const AxisMap& map = p.absorbed();
    auto& list = triangles_[{id, map.from, {to_double(map.scale[0]), to_double(map.scale[1]), to_double(map.scale[2])}}];
    if (!list) {
        const Result<FacetList> facets = facets_of(solid_, id);
        if (!facets) {
            failure_ = facets.error().message;
            return constant(false);
        }
        auto triangles = std::make_shared<TriangleList>();
        for (const Vec3& v : facets->points) triangles->points.push_back(p.point(v));
        for (const auto& f : facets->facets)
            for (std::size_t i = 2; i < f.size(); ++i) triangles->triangles.push_back({f[0], f[i - 1], f[i]});
        list = std::move(triangles);
    }
    if (list->triangles.empty()) return constant(site.negated);
    MeshData part{p.frame(), list, {}, has_flat_faces(id)};
    for (const auto& t : list->triangles) part.facets.push_back(p.facet(list->points[t[0]], list->points[t[1]], list->points[t[2]]));
    FormulaNode n = leaf(FormulaKind::kMesh, p.root_box(), site);
    n.data = static_cast<std::uint32_t>(out_.meshes.size());
    out_.meshes.push_back(std::move(part));
    return push(std::move(n));
}

}  // namespace whittle
