// leaf_distance.cpp — gathers the leaves in the root frame, finds those near a point by a grid of boxes, and asks each in its own frame.
#include "modeler/check/leaf_distance.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "csg/solid/facets.h"
#include "csg/solid/parabola.h"
#include "modeler/check/nearest_point.h"
#include "modeler/check/placed_facets.h"

namespace whittle {

namespace {

// A placement keeps shapes when its columns are orthogonal and of one length up to this share: rounding of a chain of rotations.
constexpr double kSimilar = 0x1p-40;
// Below this share of a leaf's size a value's slope is not told by steps within it, which drown in rounding, but by longer ones across the surface.
constexpr double kSlopeNoise = 0x1p-32, kLongStep = 0x1p-20;

Vec3 column(const Placement& a, int k) { return {a.linear(0, k), a.linear(1, k), a.linear(2, k)}; }

// The common stretch of all directions; 0 where there is none.
double similarity_scale(const Placement& a) {
    const Vec3 x = column(a, 0), y = column(a, 1), z = column(a, 2);
    const double s2 = glm::dot(x, x);
    const double worst = std::max({std::fabs(glm::dot(y, y) - s2), std::fabs(glm::dot(z, z) - s2), std::fabs(glm::dot(x, y)), std::fabs(glm::dot(y, z)),
                                   std::fabs(glm::dot(z, x))});
    return worst <= kSimilar * s2 ? std::sqrt(s2) : 0;
}

// The same of a placement of the plane z = 0 in itself.
double similarity_scale_2d(const Placement& a) {
    const Vec2 x(a.m[0], a.m[4]), y(a.m[1], a.m[5]);
    const double s2 = glm::dot(x, x);
    return std::max(std::fabs(glm::dot(y, y) - s2), std::fabs(glm::dot(x, y))) <= kSimilar * s2 ? std::sqrt(s2) : 0;
}

double widest(const Placement& a) {
    return std::sqrt(glm::dot(column(a, 0), column(a, 0)) + glm::dot(column(a, 1), column(a, 1)) + glm::dot(column(a, 2), column(a, 2)));
}

Placement inverse_of(const Placement& a) {
    const Vec3 x = column(a, 0), y = column(a, 1), z = column(a, 2), o(a.offset(0), a.offset(1), a.offset(2));
    const double det = determinant(a);
    const std::array<Vec3, 3> rows{glm::cross(y, z) / det, glm::cross(z, x) / det, glm::cross(x, y) / det};
    Placement r;
    for (std::size_t i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) r.m[4 * i + static_cast<std::size_t>(j)] = rows[i][j];
        r.m[4 * i + 3] = -glm::dot(rows[i], o);
    }
    return r;
}

bool is_plain(const shape::Extrusion& e) { return e.twist_deg == 0 && e.scale_top == Vec2(1); }

bool is_inside_2d(const Shape& profile, Vec2 p) {
    if (const auto* disc = std::get_if<shape::Disc>(&profile)) return glm::length(p) < disc->r;
    if (const auto* r = std::get_if<shape::Rectangle>(&profile)) return p.x > r->lo.x && p.x < r->hi.x && p.y > r->lo.y && p.y < r->hi.y;
    if (const auto* segment = std::get_if<shape::ParabolicSegment>(&profile)) return is_inside(*segment, p);
    bool inside = false;
    if (const auto* polygon = std::get_if<shape::Polygon>(&profile))
        for (const std::vector<Vec2>& c : *polygon->contours)
            for (std::size_t i = 0; i < c.size(); ++i) {
                const Vec2 u = c[i], v = c[(i + 1) % c.size()];
                if ((u.y > p.y) != (v.y > p.y) && p.x < u.x + (p.y - u.y) / (v.y - u.y) * (v.x - u.x)) inside = !inside;
            }
    return inside;
}

Vec2 in_profile(const PlacedLeaf& leaf, Vec2 p) {
    const Vec3 q = apply_to_point(leaf.profile_inverse, Vec3(p, 0));
    return {q.x, q.y};
}

// From the profile's boundary, p in its own frame.
LeafDistance profile_distance(const PlacedLeaf& leaf, Vec2 p) {
    const LeafDistance d = boundary_distance_2d(leaf.profile, p);
    return {d.curved * leaf.profile_scale, d.flat * leaf.profile_scale};
}

double share_of_height(const shape::Extrusion& e, double z) { return (std::clamp(z, e.z0, e.z1) - e.z0) / (e.z1 - e.z0); }
Vec2 scale_at(const shape::Extrusion& e, double share) { return Vec2(1) + share * (e.scale_top - Vec2(1)); }

LeafDistance extrusion_distance(const PlacedLeaf& leaf, const shape::Extrusion& e, Vec3 q) {
    const double z = std::clamp(q.z, e.z0, e.z1), share = share_of_height(e, q.z);
    const Vec2 s = scale_at(e, share);
    const double angle = e.twist_deg * share * M_PI / 180;  // undoes a clockwise twist
    const Vec2 even(s.x > 0 ? q.x / s.x : 0, s.y > 0 ? q.y / s.y : 0);  // scaled last on the way up
    const Vec2 p = in_profile(leaf, {std::cos(angle) * even.x - std::sin(angle) * even.y, std::sin(angle) * even.x + std::cos(angle) * even.y});
    LeafDistance wall = profile_distance(leaf, p);
    if (!is_plain(e) && (e.twist_deg != 0 || e.scale_top.x != e.scale_top.y)) wall = {std::min(wall.curved, wall.flat), kInfiniteDistance};
    const double above = q.z - z;
    LeafDistance d{std::hypot(wall.curved, above), std::hypot(wall.flat, above)};
    if (is_inside_2d(leaf.profile, p)) d.flat = std::min({d.flat, std::fabs(q.z - e.z0), std::fabs(q.z - e.z1)});
    return d;
}

// Distance to the cut face at `angle_deg`: the rectangle around the profile in that half plane.
double cut_face_distance(const Bounds& profile, double angle_deg, Vec3 q) {
    const double a = angle_deg * M_PI / 180;
    const double along = q.x * std::cos(a) + q.y * std::sin(a), off = q.y * std::cos(a) - q.x * std::sin(a);
    const double r = std::max(std::fabs(profile.lo.x), std::fabs(profile.hi.x));
    const double da = along - std::clamp(along, 0.0, r), dz = q.z - std::clamp(q.z, profile.lo.y, profile.hi.y);
    return std::hypot(std::hypot(da, dz), off);
}

LeafDistance revolution_distance(const PlacedLeaf& leaf, const shape::Revolution& s, Vec3 q) {
    double theta = std::atan2(q.y, q.x) * 180 / M_PI - s.start_deg;
    theta -= 360 * std::floor(theta / 360);
    double rho = std::hypot(q.x, q.y);
    if (s.fragments > 0) {  // in a sector the profile stands on the chord
        const double step = s.angle_deg / s.fragments, middle = (std::floor(theta / step) + 0.5) * step;
        rho *= std::cos((theta - middle) * M_PI / 180) / std::cos(step / 2 * M_PI / 180);
    }
    LeafDistance d;
    if (s.angle_deg >= 360 || theta <= s.angle_deg) {
        const LeafDistance right = profile_distance(leaf, in_profile(leaf, {rho, q.z}));
        const LeafDistance left = profile_distance(leaf, in_profile(leaf, {-rho, q.z}));
        d = {std::min(right.curved, left.curved), std::min(right.flat, left.flat)};
        if (s.fragments == 0) d = {std::min(d.curved, d.flat), kInfiniteDistance};
    }
    if (s.angle_deg < 360)
        d.flat = std::min({d.flat, cut_face_distance(leaf.profile_bounds, s.start_deg, q), cut_face_distance(leaf.profile_bounds, s.start_deg + s.angle_deg, q)});
    return d;
}

LeafDistance distance_in_frame(const PlacedLeaf& leaf, Vec3 p) {
    const Vec3 q = apply_to_point(leaf.inverse, p);
    if (const auto* e = std::get_if<shape::Extrusion>(&leaf.shape)) return extrusion_distance(leaf, *e, q);
    if (const auto* r = std::get_if<shape::Revolution>(&leaf.shape)) return revolution_distance(leaf, *r, q);
    return boundary_distance(leaf.shape, q);
}

// By how much the leaf's own lengths grow in the root frame, at least (of `least` only a lower bound is known) and at most.
struct Stretch {
    double least = 0, most = 0;
};

Stretch stretch_of(const PlacedLeaf& leaf) {
    return {1 / widest(leaf.inverse), widest(leaf.placement)};
}

// No slope of distance_in_frame is greater, p within twice the leaf's size; infinite where none is known.
double slope_bound(const PlacedLeaf& leaf) {
    if (std::holds_alternative<shape::Quadric>(leaf.shape) || std::holds_alternative<shape::ConvexBody>(leaf.shape)) return kInfiniteDistance;
    const double outer = widest(leaf.inverse), profile = std::max(1.0, leaf.profile_scale * widest(leaf.profile_inverse));
    if (const auto* r = std::get_if<shape::Revolution>(&leaf.shape))
        return outer * profile / (r->fragments > 0 ? std::cos(r->angle_deg / r->fragments / 2 * M_PI / 180) : 1);
    const auto* e = std::get_if<shape::Extrusion>(&leaf.shape);
    if (!e) return outer;
    const Vec3 far = glm::max(glm::abs(leaf.bounds.lo), glm::abs(leaf.bounds.hi));
    const double radius = 2 * outer * (glm::length(far) + glm::length(Vec3(leaf.placement.m[3], leaf.placement.m[7], leaf.placement.m[11])));
    const double least = std::min({1.0, e->scale_top.x, e->scale_top.y}), taper = glm::length(Vec2(1) - e->scale_top);
    const double sideways = 1 / least, upward = radius * (std::fabs(e->twist_deg) * M_PI / 180 + taper / least) / least / (e->z1 - e->z0);
    return outer * (profile * (sideways + upward) + 1);
}

// By how much the leaf is narrower around p than its profile: a step that is short below is not under a roof that ends in a line. 1 on that line itself.
double narrowing(const PlacedLeaf& leaf, Vec3 p) {
    const auto* e = std::get_if<shape::Extrusion>(&leaf.shape);
    if (!e) return 1;
    const Vec2 s = scale_at(*e, share_of_height(*e, apply_to_point(leaf.inverse, p).z));
    const double least = std::min(s.x, s.y);
    return least > 0 ? std::min(1.0, least) : 1;
}

// value / slope. Near the surface the slope is the mean of its steepness on both sides, by steps that are short against the surface's curvature; elsewhere
// it is by central differences that stay on one side.
double first_order(const PlacedLeaf& leaf, Vec3 p, double value, double LeafDistance::*part, double size, const Stretch& stretch) {
    if (!(value < kInfiniteDistance)) return kInfiniteDistance;
    const bool near = value * stretch.most <= kSlopeNoise * size;
    const double h = (near ? kLongStep * size : value * stretch.least / 8) * narrowing(leaf, p);
    Vec3 slope(0);
    for (int i = 0; i < 3; ++i) {
        Vec3 step(0);
        step[i] = h;
        const double after = distance_in_frame(leaf, p + step).*part, before = distance_in_frame(leaf, p - step).*part;
        slope[i] = (near ? after + before : after - before) / (2 * h);
    }
    const double length = glm::length(slope);
    return length > 0 && std::isfinite(length) ? std::min(value / length, value * stretch.most) : value * stretch.most;
}

Use use_of(NodeId node) {
    Use use;
    use.node = node;
    return use;
}

class Gatherer {
public:
    Gatherer(const Solid& solid, std::vector<PlacedLeaf>& leaves, PlacedFacets& facets) : solid_(solid), leaves_(leaves), facets_(facets) {}

    // False at a shape whose surface is not known here.
    bool walk(const Use& use, const Placement& outer, SourcePlace place) {
        Placement placement = outer * use.placement;
        if (use.motion != 0) placement = outer * solid_.motion(use.motion).start * use.placement;
        const SourcePlace own = solid_.label(use.label).place;
        if (own.line != 0) place = own;
        return std::visit([&](const auto& node) { return visit(node, use.node, placement, place); }, solid_.node(use.node));
    }

private:
    bool visit(const Combination& combination, NodeId, const Placement& placement, SourcePlace place) {
        return std::all_of(combination.operands.begin(), combination.operands.end(), [&](const Use& use) { return walk(use, placement, place); });
    }
    bool visit(const Shape& shape, NodeId id, const Placement& placement, SourcePlace place) {
        if (has_facets(shape)) return add_facets(id, placement, place);
        PlacedLeaf leaf;
        leaf.shape = shape;
        leaf.place = place;
        leaf.bounds = placed_bounds(solid_.bounds(id), placement);
        if (const auto* e = std::get_if<shape::Extrusion>(&shape)) return walk_profile(use_of(e->profile), Placement{}, placement, leaf);
        if (const auto* r = std::get_if<shape::Revolution>(&shape)) {
            leaf.profile_bounds = solid_.bounds(r->profile);
            faceted_ = r->fragments > 0;
            return walk_profile(use_of(r->profile), Placement{}, placement, leaf);
        }
        add(std::move(leaf), placement);
        return true;
    }

    // Shapes of facets, and sides in slices.
    static bool has_facets(const Shape& shape) {
        if (const auto* e = std::get_if<shape::Extrusion>(&shape)) return e->slices > 0 && (e->twist_deg != 0 || e->scale_top.x != e->scale_top.y);
        return std::holds_alternative<shape::Polyhedron>(shape) || std::holds_alternative<shape::FacetedBall>(shape) ||
               std::holds_alternative<shape::FacetedFrustum>(shape);
    }
    bool add_facets(NodeId id, const Placement& placement, SourcePlace place) {
        if (determinant(placement) == 0) return true;
        if (const auto* p = std::get_if<shape::Polyhedron>(&std::get<Shape>(solid_.node(id)))) {
            facets_.add(*p->mesh, placement, place);
            return true;
        }
        const auto facets = facets_of(solid_, id);
        if (facets) facets_.add(*facets, placement, place);
        return facets.has_value();
    }

    // One leaf for each shape of the profile.
    bool walk_profile(const Use& use, const Placement& inner, const Placement& outer, const PlacedLeaf& like) {
        const Placement placement = inner * use.placement;
        const Node& node = solid_.node(use.node);
        if (const auto* combination = std::get_if<Combination>(&node))
            return std::all_of(combination->operands.begin(), combination->operands.end(),
                               [&](const Use& operand) { return walk_profile(operand, placement, outer, like); });
        PlacedLeaf leaf = like;
        leaf.profile = std::get<Shape>(node);
        const double scale = similarity_scale_2d(placement);
        const auto* extrusion = std::get_if<shape::Extrusion>(&leaf.shape);
        const bool plain = extrusion && is_plain(*extrusion);
        const bool fold = plain && scale == 0;  // the placement can move the whole solid instead
        if (!fold) leaf.profile_inverse = inverse_of(placement);
        if (scale > 0) leaf.profile_scale = scale;
        leaf.exact = plain || (!extrusion && !faceted_ && scale > 0);
        if (plain) {
            Bounds box = placed_bounds(solid_.bounds(use.node), placement);
            box.lo.z = extrusion->z0, box.hi.z = extrusion->z1;
            leaf.bounds = placed_bounds(box, outer);
        }
        add(std::move(leaf), fold ? outer * placement : outer);
        return true;
    }

    void add(PlacedLeaf leaf, const Placement& placement) {
        if (determinant(placement) == 0) return;  // flattened: no solid
        leaf.placement = placement;
        leaf.inverse = inverse_of(placement);
        leaf.scale = leaf.exact ? similarity_scale(placement) : 0;
        leaf.steepest = slope_bound(leaf);
        leaves_.push_back(std::move(leaf));
    }

    const Solid& solid_;
    std::vector<PlacedLeaf>& leaves_;
    PlacedFacets& facets_;
    bool faceted_ = false;  // the revolution being walked
};

double distance_to_bounds(const Bounds& b, Vec3 p) { return glm::length(glm::max(glm::max(b.lo - p, p - b.hi), Vec3(0))); }

bool is_curved(const PlacedLeaf& leaf) {
        if (const auto* e = std::get_if<shape::Extrusion>(&leaf.shape)) return is_curved_2d(leaf.profile) || e->twist_deg != 0 || e->scale_top.x != e->scale_top.y;
    if (const auto* r = std::get_if<shape::Revolution>(&leaf.shape)) return r->fragments == 0 || is_curved_2d(leaf.profile);
    return !(std::holds_alternative<shape::Box>(leaf.shape) || std::holds_alternative<shape::HalfSpace>(leaf.shape));
}

}  // namespace

LeafDistance leaf_distance(const PlacedLeaf& leaf, Vec3 p, const LeafDistance& most) {
    const LeafDistance d = distance_in_frame(leaf, p);
    if (leaf.scale > 0) return {d.curved * leaf.scale, d.flat * leaf.scale};
    const Stretch stretch = stretch_of(leaf);
    const Vec3 size = leaf.bounds.hi - leaf.bounds.lo;
    const double extent = std::isfinite(glm::length(size)) ? glm::length(size) : 1 + glm::length(p);
    const auto part = [&](double LeafDistance::*which) {
        return d.*which > leaf.steepest * (most.*which) ? kInfiniteDistance : first_order(leaf, p, d.*which, which, extent, stretch);
    };
    return {part(&LeafDistance::curved), part(&LeafDistance::flat)};
}

// Cells of the box of all bounded leaves, each with the leaves whose boxes meet it.
struct LeafDistances::Grid {
    Bounds box;
    int n = 1;
    std::vector<std::vector<std::uint32_t>> cells;

    std::array<int, 3> cell_of(Vec3 p) const {
        std::array<int, 3> c{};
        for (int i = 0; i < 3; ++i) {
            const double size = box.hi[i] - box.lo[i];
            const double at = size > 0 ? (p[i] - box.lo[i]) / size * n : 0;
            c[static_cast<std::size_t>(i)] = static_cast<int>(std::clamp(std::floor(at), 0.0, n - 1.0));
        }
        return c;
    }
    template <class Visit>
    void over(Vec3 lo, Vec3 hi, const Visit& visit) const {
        const std::array<int, 3> a = cell_of(lo), b = cell_of(hi);
        for (int z = a[2]; z <= b[2]; ++z)
            for (int y = a[1]; y <= b[1]; ++y)
                for (int x = a[0]; x <= b[0]; ++x) visit(static_cast<std::size_t>((z * n + y) * n + x));
    }
};

LeafDistances::LeafDistances() = default;
LeafDistances::LeafDistances(LeafDistances&&) noexcept = default;
LeafDistances& LeafDistances::operator=(LeafDistances&&) noexcept = default;
LeafDistances::~LeafDistances() = default;

Result<LeafDistances> LeafDistances::of(const Solid& solid) {
    LeafDistances r;
    r.facets_ = std::make_unique<PlacedFacets>();
    if (!Gatherer(solid, r.leaves_, *r.facets_).walk(solid.root(), Placement{}, {}))
        return fail(Fault::kScene, "check cannot cut an extrusion into its slices");
    const auto flat = std::stable_partition(r.leaves_.begin(), r.leaves_.end(), is_curved);
    r.curved_ = static_cast<std::size_t>(flat - r.leaves_.begin());
    r.facets_->finish();
    r.grid_ = std::make_unique<Grid>();
    Grid& grid = *r.grid_;
    grid.box = solid.root_bounds();
    grid.n = std::clamp(static_cast<int>(std::cbrt(2.0 * static_cast<double>(r.leaves_.size()))), 1, 32);
    grid.cells.resize(static_cast<std::size_t>(grid.n * grid.n * grid.n));
    for (std::size_t i = 0; i < r.leaves_.size(); ++i)
        grid.over(r.leaves_[i].bounds.lo, r.leaves_[i].bounds.hi, [&](std::size_t cell) { grid.cells[cell].push_back(static_cast<std::uint32_t>(i)); });
    return r;
}

LeafDistances::Nearest LeafDistances::nearest(Vec3 p, double curved_bound, double flat_bound, double reach) const {
    Nearest best;
    const double far = reach * std::max(curved_bound, flat_bound);
    const auto offer = [&](const PlacedLeaf& leaf) {
        const LeafDistance d = leaf_distance(leaf, p, {curved_bound * best.ratio, flat_bound * best.ratio});
        const auto take = [&](double distance, double bound) {
            if (!(distance < bound * best.ratio)) return;
            best = {distance / bound, distance, bound, leaf.place};
        };
        if (d.curved < kInfiniteDistance) take(d.curved, curved_bound);
        if (d.flat < kInfiniteDistance) take(d.flat, flat_bound);
    };
    // Curved leaves come first in a cell; flat ones matter only where none of those explains the point.
    grid_->over(p - far, p + far, [&](std::size_t cell) {
        for (const std::uint32_t i : grid_->cells[cell]) {
            if (i >= curved_ && best.ratio <= 1) break;
            if (distance_to_bounds(leaves_[i].bounds, p) <= far) offer(leaves_[i]);
        }
    });
    const auto offer_facet = [&](const PlacedFacets::Nearest& facet) {
        if (facet.distance < flat_bound * best.ratio) best = {facet.distance / flat_bound, facet.distance, flat_bound, facet.place};
    };
    if (!(best.ratio <= 1)) offer_facet(facets_->within(p, reach * flat_bound));
    if (best.distance < kInfiniteDistance) return best;
    offer_facet(facets_->nearest(p));
    for (const PlacedLeaf& leaf : leaves_)
        if (distance_to_bounds(leaf.bounds, p) < best.distance) offer(leaf);
    return best;
}

}  // namespace whittle
