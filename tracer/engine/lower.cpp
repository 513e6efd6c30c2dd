// lower.cpp — the walk over the solid, and the shapes that planes and quadrics make.
#include "tracer/engine/lower.h"

#include <algorithm>

#include "tracer/engine/formula_builder.h"

namespace whittle {

namespace {

Bounds intersection(const Bounds& a, const Bounds& b) { return {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)}; }

Bounds hull(const Bounds& a, const Bounds& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

}  // namespace

Result<Formula> lower(const Solid& solid) { return FormulaBuilder(solid).run(); }

Result<Formula> FormulaBuilder::run() {
    const Material none;
    Site site;
    site.material = &none;
    out_.root = use(solid_.root(), site);
    if (!failure_.empty()) return fail(Fault::kScene, failure_);
    order_cuts();
    const FormulaNode& root = out_.nodes[out_.root];
    if (!root.outside_value && !root.box.empty()) out_.table.bound_by(root.box);
    return std::move(out_);
}

// At each difference the uses of what is cut change places with those of its cutters: a use's shift is summed over the differences above it.
void FormulaBuilder::order_cuts() {
    std::vector<std::int64_t> step(out_.uses.size() + 1, 0);
    for (const Parted& d : differences_) {
        const auto cut = static_cast<std::int64_t>(d.middle - d.first), cutters = static_cast<std::int64_t>(d.end - d.middle);
        step[d.first] += cutters;
        step[d.middle] -= cutters + cut;
        step[d.end] += cut;
    }
    std::int64_t shift = 0;
    for (std::size_t i = 0; i < out_.uses.size(); ++i) {
        shift += step[i];
        out_.uses[i].cut_depth = static_cast<std::uint32_t>(static_cast<std::int64_t>(i) + shift);
    }
}

FormulaId FormulaBuilder::push(FormulaNode node) {
    out_.nodes.push_back(std::move(node));
    return static_cast<FormulaId>(out_.nodes.size() - 1);
}

FormulaId FormulaBuilder::constant(bool value) {
    FormulaNode n;
    n.kind = value ? FormulaKind::kEverything : FormulaKind::kNothing;
    n.outside_value = value;
    return push(std::move(n));
}

FormulaId FormulaBuilder::use(const Use& use, const Site& site) {
    Site inner = site;
    if (use.motion == 0) {
        inner.chain = site.chain.then(use.placement);
    } else {
        // A group of its own: what stands above, the use's placement too, is rounded once, what stands below starts anew.
        inner.motion = static_cast<MotionId>(out_.motions.size());
        out_.motions.push_back({site.motion, site.chain.then(use.placement).whole(), MotionPath(solid_.motion(use.motion))});
        inner.chain = Chain();
    }
    Material mixed;
    if (use.label != kNoLabel) {
        const Label& label = solid_.label(use.label);
        mixed = nested(*site.material, label.material);
        inner.material = &mixed;
        if (label.place.line != 0) inner.place = label.place;
    }
    return node(use.node, inner);
}

FormulaId FormulaBuilder::node(NodeId id, const Site& site) {
    const Node& n = solid_.node(id);
    // Straight sides under a twist are united first: nothing makes two that nearly abut one surface there.
    if (site.turning && has_straight_sides(id)) return turned_polygons(id, site);
    if (const auto* c = std::get_if<Combination>(&n)) return combination(*c, site);
    return shape(id, std::get<Shape>(n), site);
}

FormulaId FormulaBuilder::combination(const Combination& c, const Site& site) {
    const std::size_t first = out_.uses.size();
    std::size_t middle = first;
    std::vector<FormulaId> parts;
    for (std::size_t i = 0; i < c.operands.size(); ++i) {
        Site each = site;
        if (c.op == SetOp::kDifference && i > 0) {
            each.negated = !site.negated;
            ++each.subtractions;
        }
        parts.push_back(use(c.operands[i], each));
        if (i == 0) middle = out_.uses.size();
    }
    if (c.op == SetOp::kDifference) differences_.push_back({first, middle, out_.uses.size()});
    return c.op == SetOp::kUnion ? any_of(std::move(parts), site) : all_of(std::move(parts), site);
}

FormulaId FormulaBuilder::all_of(std::vector<FormulaId> children, const Site& site) {
    return join(site.negated ? FormulaKind::kOr : FormulaKind::kAnd, std::move(children));
}

FormulaId FormulaBuilder::any_of(std::vector<FormulaId> children, const Site& site) {
    return join(site.negated ? FormulaKind::kAnd : FormulaKind::kOr, std::move(children));
}

FormulaId FormulaBuilder::join(FormulaKind kind, const std::vector<FormulaId>& children) {
    const bool is_and = kind == FormulaKind::kAnd;
    FormulaNode n;
    n.kind = kind;
    FormulaId merged = 0;
    bool has_merged = false;
    for (const FormulaId id : children) {
        FormulaNode& child = out_.nodes[id];
        const bool neutral = child.kind == (is_and ? FormulaKind::kEverything : FormulaKind::kNothing);
        const bool absorbing = child.kind == (is_and ? FormulaKind::kNothing : FormulaKind::kEverything);
        if (absorbing) return constant(!is_and);
        if (neutral) continue;
        if (child.kind == kind) {
            n.children.insert(n.children.end(), child.children.begin(), child.children.end());
            continue;
        }
        // Two cells of one use are one cell: AND of cells, OR of complements of cells.
        if (child.kind == FormulaKind::kCell && child.negated == !is_and) {
            if (has_merged && out_.nodes[merged].use == child.use) {
                FormulaNode& into = out_.nodes[merged];
                into.half_spaces.insert(into.half_spaces.end(), child.half_spaces.begin(), child.half_spaces.end());
                into.box = intersection(into.box, child.box);
                continue;
            }
            merged = id;
            has_merged = true;
        }
        n.children.push_back(id);
    }
    if (n.children.empty()) return constant(is_and);
    if (n.children.size() == 1) return n.children.front();
    // The box outside which the node is constant.
    bool bounded = false;
    Bounds inside = everywhere(), spread;
    for (const FormulaId id : n.children) {
        const FormulaNode& child = out_.nodes[id];
        if (child.outside_value == is_and) {
            spread = hull(spread, child.box);
        } else {
            bounded = true;
            inside = intersection(inside, child.box);
        }
    }
    n.outside_value = bounded ? !is_and : is_and;
    n.box = bounded ? inside : spread;
    if (bounded && n.box.empty()) return constant(!is_and);
    return push(std::move(n));
}

FormulaNode FormulaBuilder::leaf(FormulaKind kind, const Bounds& box, const Site& site) {
    FormulaNode n;
    n.kind = kind;
    n.negated = n.outside_value = site.negated;
    n.exact = site.exact;
    n.box = box;
    n.room = kBoxRoom * site.chain.rounding_for(0);
    n.use = site.use;
    return n;
}

FormulaId FormulaBuilder::cell(std::vector<HalfSpaceRef> half_spaces, const Bounds& box, const Site& site) {
    if (box.empty() || !drop_constant_planes(half_spaces)) return constant(site.negated);
    if (half_spaces.empty()) return constant(!site.negated);
    FormulaNode n = leaf(FormulaKind::kCell, box, site);
    n.half_spaces = std::move(half_spaces);
    return push(std::move(n));
}

const SharedMaterial& FormulaBuilder::shared(const Material& material) {
    constexpr std::size_t kRecent = 8;
    for (const SharedMaterial& m : materials_)
        if (*m == material) return m;
    if (materials_.size() == kRecent) materials_.erase(materials_.begin());
    return materials_.emplace_back(material);
}

FormulaId FormulaBuilder::shape(NodeId id, const Shape& shape, Site site) {
    if (site.use == kNoUse) {
        site.use = static_cast<std::uint32_t>(out_.uses.size());
        out_.uses.push_back({shared(*site.material), site.place, site.subtractions > 0, site.subtractions, 0});
    }
    if (site.turning) return turned_shape(id, shape, site);
    return std::visit(
        [&](const auto& s) -> FormulaId {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, shape::Box>) {
                return box(s.lo, s.hi, site);
            } else if constexpr (std::is_same_v<S, shape::FacetedBall> || std::is_same_v<S, shape::FacetedFrustum>) {
                const FormulaId belts = of_belts(s, site);
                return belts == kNoFormula ? faceted(id, site) : belts;
            } else if constexpr (std::is_same_v<S, shape::Polyhedron>) {
                return faceted(id, site);
            } else if constexpr (std::is_same_v<S, shape::ConvexBody>) {
                return convex(id, s, site);
            } else if constexpr (std::is_same_v<S, shape::Extrusion>) {
                if (s.twist_deg == 0 && s.scale_top == Vec2(1)) return operator_shape(s, site);
                if (const auto* segment = profile_segment(s); segment && s.twist_deg == 0 && s.scale_top.x == s.scale_top.y) return tapered(id, s, *segment, site);
                if (s.twist_deg == 0 && s.slices == 0 && has_straight_sides(s.profile)) return stretched(id, s, site);
                return s.slices == 0 ? turned(id, s, site) : faceted(id, site);
            } else if constexpr (std::is_same_v<S, shape::Revolution>) {
                if (s.fragments == 0) return operator_shape(s, site);
                return faceted(id, site);
            } else {
                return operator_shape(s, site);
            }
        },
        shape);
}

FormulaId FormulaBuilder::box(Vec3 lo, Vec3 hi, const Site& site) {
    Placer p(out_, site.chain, site.motion, {lo, hi}, Absorb::kAny);
    std::vector<HalfSpaceRef> sides;
    for (int i = 0; i < 3; ++i) {
        if (std::isfinite(lo[i])) sides.push_back(p.axis_plane(i, lo[i], false));
        if (std::isfinite(hi[i])) sides.push_back(p.axis_plane(i, hi[i], true));
    }
    return cell(std::move(sides), p.root_box(), site);
}

FormulaId FormulaBuilder::operator_shape(const shape::Ellipsoid& s, const Site& site) {
    Placer p(out_, site.chain, site.motion, {-s.radii, s.radii}, Absorb::kAny);
    return cell({p.ellipsoid(Vec3(0), s.radii)}, p.root_box(), site);
}

FormulaId FormulaBuilder::operator_shape(const shape::Frustum& s, const Site& site) {
    const double r = std::max(s.r0, s.r1);
    const Bounds around{Vec3(-r, -r, s.z0), Vec3(r, r, s.z1)};
    const AxisMap& map = site.chain.inner();
    const auto scale = [&](std::size_t axis) {
        for (std::size_t i = 0; i < 3; ++i)
            if (map.from[i] == axis) return map.scale[i] < 0 ? -map.scale[i] : map.scale[i];
        return Wide(1);
    };
    Placer p(out_, site.chain, site.motion, around, scale(0) == scale(1) ? Absorb::kAny : Absorb::kNothing);
    const HalfSpaceRef side = s.r0 == s.r1 ? p.cylinder(2, Vec3(0), s.r0) : p.cone(2, Vec3(0), s.z0, s.z1, s.r0, s.r1);
    return cell({p.axis_plane(2, s.z0, false), p.axis_plane(2, s.z1, true), side}, p.root_box(), site);
}

FormulaId FormulaBuilder::operator_shape(const shape::Torus& s, const Site& site) {
    const double r = s.major + s.minor;
    Placer p(out_, site.chain, site.motion, {Vec3(-r, -r, -s.minor), Vec3(r, r, s.minor)}, Absorb::kUniformScale);
    const FormulaId sheet = cell({p.torus(Vec3(0), s.major, s.minor)}, p.root_box(), site);
    if (s.minor <= s.major) return sheet;
    return any_of({sheet, cell({p.torus_core(Vec3(0), s.major, s.minor)}, p.root_box(), site)}, site);
}

FormulaId FormulaBuilder::operator_shape(const shape::HalfSpace& s, const Site& site) {
    Placer p(out_, site.chain, site.motion, everywhere(), Placer::is_axis_plane(s.n, s.d) ? Absorb::kAny : Absorb::kRigid);
    return cell({p.plane(s.n, s.d)}, everywhere(), site);
}

FormulaId FormulaBuilder::operator_shape(const shape::Quadric& s, const Site& site) {
    Placer p(out_, site.chain, site.motion, everywhere(), Absorb::kExact);
    return cell({p.quadric(s.c)}, everywhere(), site);
}

FormulaId FormulaBuilder::operator_shape(const shape::Capsule& s, const Site& site) {
    const Bounds around{glm::min(s.p, s.q) - s.r, glm::max(s.p, s.q) + s.r};
    Placer p(out_, site.chain, site.motion, around, Absorb::kUniformScale);
    std::vector<FormulaId> parts{cell({p.ball(s.p, s.r)}, p.root_box(), site)};
    if (s.p == s.q) return parts.front();
    parts.push_back(cell({p.ball(s.q, s.r)}, p.root_box(), site));
    const Vec3 way = s.q - s.p;
    for (int i = 0; i < 3; ++i)
        if (way[(i + 1) % 3] == 0 && way[(i + 2) % 3] == 0) {
            const double a = std::min(s.p[i], s.q[i]), b = std::max(s.p[i], s.q[i]);
            parts.push_back(cell({p.axis_plane(i, a, false), p.axis_plane(i, b, true), p.cylinder(i, s.p, s.r)}, p.root_box(), site));
            return any_of(std::move(parts), site);
        }
    Placer ends(out_, site.chain, site.motion, around, Absorb::kRigid);
    parts.push_back(cell({p.tube(s.p, s.q, s.r), ends.plane(way, glm::dot(way, s.q)), ends.plane(-way, -glm::dot(way, s.p))}, p.root_box(), site));
    return any_of(std::move(parts), site);
}

FormulaId FormulaBuilder::operator_shape(const shape::RoundBox& s, const Site& site) {
    if (s.r == 0) return box(s.lo, s.hi, site);
    Placer p(out_, site.chain, site.motion, {s.lo, s.hi}, Absorb::kUniformScale);
    const Vec3 a = s.lo + s.r, b = s.hi - s.r;
    const std::array<Vec3, 2> corner{a, b};
    std::vector<FormulaId> parts;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        if (a[j] < b[j] && a[k] < b[k])
            parts.push_back(cell({p.axis_plane(i, s.lo[i], false), p.axis_plane(i, s.hi[i], true), p.axis_plane(j, a[j], false), p.axis_plane(j, b[j], true),
                                  p.axis_plane(k, a[k], false), p.axis_plane(k, b[k], true)}, p.root_box(), site));
        if (!(a[i] < b[i])) continue;
        for (std::size_t m = 0; m < 4; ++m) {
            if ((m % 2 == 1 && !(a[j] < b[j])) || (m / 2 == 1 && !(a[k] < b[k]))) continue;
            Vec3 through = a;
            through[j] = corner[m % 2][j];
            through[k] = corner[m / 2][k];
            parts.push_back(cell({p.axis_plane(i, a[i], false), p.axis_plane(i, b[i], true), p.cylinder(i, through, s.r)}, p.root_box(), site));
        }
    }
    for (std::size_t m = 0; m < 8; ++m) {
        const Vec3 centre{corner[m & 1].x, corner[(m >> 1) & 1].y, corner[m >> 2].z};
        parts.push_back(cell({p.ball(centre, s.r)}, p.root_box(), site));
    }
    return any_of(std::move(parts), site);
}

FormulaId FormulaBuilder::operator_shape(const shape::Extrusion& s, const Site& site) {
    const Bounds& flat = solid_.bounds(s.profile);
    const Bounds around{Vec3(flat.lo.x, flat.lo.y, s.z0), Vec3(flat.hi.x, flat.hi.y, s.z1)};
    Placer p(out_, site.chain, site.motion, around, Absorb::kAny);
    const FormulaId ends = cell({p.axis_plane(2, s.z0, false), p.axis_plane(2, s.z1, true)}, p.root_box(), site);
    Site within = site;
    within.heights = {s.z0, s.z1};
    return all_of({ends, node(s.profile, within)}, site);
}

FormulaId FormulaBuilder::operator_shape(const shape::Disc& s, const Site& site) {
    const AxisMap& map = site.chain.inner();
    Placer p(out_, site.chain, site.motion, swept(Vec2(-s.r), Vec2(s.r), site), map.is_uniform() ? Absorb::kAny : Absorb::kNothing);
    return cell({p.cylinder(2, Vec3(0), s.r)}, p.root_box(), site);
}

FormulaId FormulaBuilder::operator_shape(const shape::Rectangle& s, const Site& site) {
    return box(Vec3(s.lo, -HUGE_VAL), Vec3(s.hi, HUGE_VAL), site);
}

}  // namespace whittle
