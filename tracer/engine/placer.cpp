// placer.cpp — shapes' numbers in their frame, and the table of supports.
#include "tracer/engine/placer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <tuple>

#include "csg/solid/directed.h"
#include "tracer/engine/mutation.h"

namespace whittle {

namespace {

Wide magnitude(Wide x) { return x < 0 ? -x : x; }

std::uint64_t mix(std::uint64_t h, std::uint64_t v) {
    h ^= v + 0x9E3779B97F4A7C15u + (h << 6) + (h >> 2);
    h *= 0xFF51AFD7ED558CCDu;
    return h ^ (h >> 32);
}

template <std::size_t N>
std::uint64_t hash_of(const std::array<double, N>& a, std::uint64_t h) {
    for (const double x : a) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        h = mix(h, bits);
    }
    return h;
}

void include(Bounds& a, const Bounds& b) {
    if (b.empty()) return;
    a = a.empty() ? b : Bounds{glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

bool is_power_of_two(Wide x) {
    int exponent = 0;
    return std::frexp(to_double(x), &exponent) == 0.5 && x == to_double(x);
}

bool can_absorb(const AxisMap& map, Absorb absorb) {
    if (absorb == Absorb::kAny) return true;
    if (absorb == Absorb::kUniformScale) return map.is_uniform();
    if (absorb == Absorb::kExact)
        return std::all_of(map.scale.begin(), map.scale.end(), [](Wide x) { return is_power_of_two(magnitude(x)); }) && map.shift == std::array<Wide, 3>{0, 0, 0};
    if (absorb == Absorb::kRigid) return map.is_uniform() && is_power_of_two(magnitude(map.scale[0]));
    return false;
}

}  // namespace

SupportTable::SupportTable() { frame(Placement{}, 0); }

FrameId SupportTable::frame(const Placement& placement, MotionId motion, const Twist* twist, const Frame* outer) {
    const std::uint64_t h = hash_of(placement.m, twist ? mix(motion, std::hash<double>()(twist->from)) : motion);
    const auto is_turned_so = [&](const Frame& f) { return twist ? f.twist && *f.twist == *twist : !f.twist; };
    const auto stands_so = [&](const Frame& f) { return f.placement == placement && (outer ? f.section && stand_alike(f.section->frame, *outer) : !f.section); };
    const FrameId known = frames_by_hash_.find(h, [&](FrameId k) { return stands_so(frames[k]) && frames[k].motion == motion && is_turned_so(frames[k]); });
    if (known != IdTable::kNone) return known;
    const auto id = static_cast<FrameId>(frames.size());
    frames.push_back(outer ? make_frame(placement, *outer) : make_frame(placement));
    frames.back().motion = motion;
    if (twist) frames.back().twist = std::make_shared<const Twist>(*twist);
    if (motion != 0) frames.back().identity = false;
    frames_by_hash_.insert(h, id);
    return id;
}

FrameId SupportTable::frame_of(FrameId like, std::shared_ptr<const ConvexHullBody> body) {
    frames.push_back(frames[like]);
    frames.back().body = std::move(body);
    return static_cast<FrameId>(frames.size() - 1);
}

SupportId SupportTable::add(const Support& support, const Bounds& box, double rounding, double rounding_per_size) {
    const double extent = box.empty() ? 0 : std::max({box.hi.x - box.lo.x, box.hi.y - box.lo.y, box.hi.z - box.lo.z});
    const std::uint64_t h = hash_of(support.p, static_cast<std::uint64_t>(support.kind) * 8 + support.axis + (std::uint64_t{support.frame} << 8));
    const SupportId known = supports_by_hash_.find(h, [&](SupportId k) { return supports[k] == support && !mutated(Mutation::kOwnIdentity); });
    if (known != IdTable::kNone) {
        Occurrence& o = occurrences[known];
        include(o.box, box);
        o.extent = std::max(o.extent, extent);
        o.rounding = std::max(o.rounding, rounding);
        o.rounding_per_size = std::max(o.rounding_per_size, rounding_per_size);
        return known;
    }
    const auto id = static_cast<SupportId>(supports.size());
    supports.push_back(support);
    occurrences.push_back({box, extent, rounding, rounding_per_size});
    supports_by_hash_.insert(h, id);
    return id;
}

void SupportTable::keep_frames() {
    supports = {};
    occurrences = {};
    frames_by_hash_ = {};
    supports_by_hash_ = {};
}

void SupportTable::bound_by(const Bounds& box) {
    const Vec3 size = box.hi - box.lo;
    const double extent = std::max({size.x, size.y, size.z});
    if (!std::isfinite(extent)) return;
    for (Occurrence& o : occurrences) {
        if (std::isfinite(o.extent)) continue;
        o.box = {glm::max(o.box.lo, box.lo), glm::min(o.box.hi, box.hi)};
        o.extent = extent;
        double reach = 0;
        for (int i = 0; i < 3; ++i) reach = std::max({reach, std::abs(box.lo[i]), std::abs(box.hi[i])});
        o.rounding += o.rounding_per_size * reach;
    }
}

namespace {

// The largest coordinate of what was at most `size` from the origin.
Wide reach_of_map(const AxisMap& map, double size) {
    Wide most = 0;
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, magnitude(map.scale[i]) * size + magnitude(map.shift[i]));
    return most;
}

// The frame in whose plane z = 0 the section lies.
Frame frame_above(const ChainSection& section) {
    const Placement placement = section.above.whole();
    const ChainSection* const next = section.above.section().get();
    return next ? make_frame(placement, frame_above(*next)) : make_frame(placement);
}

// Of what has the section there, in the root frame; empty where the box misses the plane by more than `room`.
Bounds box_of_section(const ChainSection& section, Bounds box, double room) {
    if (box.lo.z > room || box.hi.z < -room) return {};
    box.lo.z = section.heights[0];
    box.hi.z = section.heights[1];
    box = placed_bounds(box, section.above.whole());
    const ChainSection* const next = section.above.section().get();
    return next ? box_of_section(*next, box, room) : box;
}

}  // namespace

Placer::Placer(Formula& formula, const Chain& chain, MotionId motion, const Bounds& box, Absorb absorb, const Twist* twist) : formula_(formula) {
    const bool taken = can_absorb(chain.inner(), absorb);
    if (taken) map_ = chain.inner();
    const Placement whole = chain.whole();
    const ChainSection* const section = chain.section().get();
    const std::optional<Frame> outer = section ? std::optional(frame_above(*section)) : std::nullopt;
    frame_ = formula.table.frame(taken ? chain.outer() : whole, motion, twist, outer ? &*outer : nullptr);
    root_box_ = everywhere();
    double size = 0;
    for (int i = 0; i < 3; ++i)
        for (const double x : {box.lo[i], box.hi[i]})
            if (std::isfinite(x)) size = std::max(size, std::abs(x));
    rounding_ = chain.rounding_for(size);
    rounding_per_size_ = (chain.rounding_for(1) - chain.rounding_for(0)) * most_shrunk();
    formula_.largest_displacement = std::max(formula_.largest_displacement, taken ? chain.displacement_of_outer(to_double(reach_of_map(map_, size))) : chain.displacement_of_whole(size));
    const bool finite = std::isfinite(box.lo.x + box.lo.y + box.lo.z + box.hi.x + box.hi.y + box.hi.z);
    if (finite) {
        const Bounds placed = placed_bounds(box, whole);
        root_box_ = swept_bounds(formula.motions, motion, section ? box_of_section(*section, placed, kBoxRoom * rounding_) : placed);
        // What moves is placed once more for every time, with a few dozen roundings.
        constexpr double kRoundingOfPath = 0x1p-46;
        const double room = kBoxRoom * rounding_ + (motion == 0 ? 0 : kRoundingOfPath * (glm::length(root_box_.lo) + glm::length(root_box_.hi)));
        root_box_.lo -= room;
        root_box_.hi += room;
    }
}

// At most so many times its size in the root frame is a thing's size in the shape's own coordinates.
double Placer::most_shrunk() const {
    double frame = 0, own = 0;
    const auto& inverse = formula_.table.frames[frame_].inverse;
    for (std::size_t i = 0; i < 3; ++i) {
        frame = std::max(frame, std::abs(inverse[3 * i]) + std::abs(inverse[3 * i + 1]) + std::abs(inverse[3 * i + 2]));
        own = std::max(own, 1 / to_double(magnitude(map_.scale[i])));
    }
    return frame * own;
}

double Placer::rounded(Wide x) {
    const double r = to_double(x) + 0.0;
    if (x == r) return r;
    formula_.largest_displacement = std::max(formula_.largest_displacement, to_double(magnitude(x - r)));
    return r;
}

double Placer::coordinate(std::size_t i, double local) { return rounded(local == 0 ? map_.shift[i] : map_.scale[i] * local + map_.shift[i]); }

int Placer::axis_of(int axis) const {
    for (int i = 0; i < 3; ++i)
        if (map_.from[static_cast<std::size_t>(i)] == axis) return i;
    return axis;
}

Vec3 Placer::point(Vec3 p) { return {coordinate(0, p[map_.from[0]]), coordinate(1, p[map_.from[1]]), coordinate(2, p[map_.from[2]])}; }

double Placer::length(double r, int axis) { return rounded(magnitude(map_.scale[static_cast<std::size_t>(axis_of(axis))]) * r); }

HalfSpaceRef Placer::add(SupportKind kind, int axis, std::array<double, 10> p, bool inverted) { return add_to(frame_, kind, axis, p, inverted); }

HalfSpaceRef Placer::add_to(FrameId frame, SupportKind kind, int axis, std::array<double, 10> p, bool inverted) {
    Support s;
    s.kind = kind;
    s.axis = static_cast<std::uint8_t>(axis);
    s.frame = frame;
    for (double& x : p) x += 0.0;
    s.p = p;
    return {formula_.table.add(s, root_box_, rounding_, rounding_per_size_), inverted};
}

HalfSpaceRef Placer::axis_plane(int axis, double value, bool below) {
    const int i = axis_of(axis);
    const bool flip = map_.scale[static_cast<std::size_t>(i)] < 0;
    const double at = coordinate(static_cast<std::size_t>(i), value);
    if (const auto root = in_root(i, at)) return add_to(0, SupportKind::kAxisPlane, root->axis, {root->value}, below == (flip != root->flipped));
    return add(SupportKind::kAxisPlane, i, {at}, below == flip);
}

// What turns about an axis keeps the planes across it: faces of one height are one support then, however far apart the parts stand.
std::optional<Placer::RootPlane> Placer::in_root(int i, double value) const {
    const Frame& frame = formula_.table.frames[frame_];
    if (frame.motion != 0 || frame.identity || frame.section) return std::nullopt;
    const auto& m = frame.placement.m;
    for (int k = 0; k < 3; ++k) {
        const auto entry = [&](int column) { return m[static_cast<std::size_t>(4 * k + (i + column) % 3)]; };
        if (entry(0) == 0 || entry(1) != 0 || entry(2) != 0) continue;
        const double way = entry(0) * value, offset = frame.placement.offset(k), at = way + offset;
        const bool exact = std::fma(entry(0), value, -way) == 0 && sum_error(way, offset, at) == 0 && (way == 0 ? value == 0 : std::abs(way) > kProductErrorExact);
        if (!exact) return std::nullopt;
        return RootPlane{k, at, entry(0) < 0};
    }
    return std::nullopt;
}

bool Placer::is_axis_plane(Vec3 n, double d) {
    if ((n.x != 0) + (n.y != 0) + (n.z != 0) != 1) return false;
    const double entry = n.x + n.y + n.z;
    return std::fma(d / entry, entry, -d) == 0;
}

HalfSpaceRef Placer::plane(Vec3 n, double d) {
    if (is_axis_plane(n, d)) {
        const int i = n.x != 0 ? 0 : n.y != 0 ? 1 : 2;
        return axis_plane(i, d / n[i], n[i] > 0);
    }
    // The scale is a power of two: it goes into the offset, which it does not round.
    Vec3 m;
    Wide offset = magnitude(map_.scale[0]) * d;
    for (std::size_t i = 0; i < 3; ++i) {
        const double k = map_.scale[i] < 0 ? -n[map_.from[i]] : n[map_.from[i]];
        m[static_cast<int>(i)] = k;
        offset += k * map_.shift[i];
    }
    bool inverted = false;
    for (int i = 0; i < 3; ++i)
        if (m[i] != 0) {
            inverted = m[i] < 0;
            break;
        }
    const double sign = inverted ? -1 : 1;
    return add(SupportKind::kPlane, 0, {sign * m.x, sign * m.y, sign * m.z, sign * rounded(offset)}, inverted);
}

HalfSpaceRef Placer::ball(Vec3 centre, double r) {
    if (!map_.is_uniform()) return ellipsoid(centre, Vec3(r));
    const Vec3 c = point(centre);
    return add(SupportKind::kBall, 0, {c.x, c.y, c.z, length(r, 0)}, false);
}

HalfSpaceRef Placer::ellipsoid(Vec3 centre, Vec3 radii) {
    const Vec3 c = point(centre);
    Vec3 r;
    for (std::size_t i = 0; i < 3; ++i) r[static_cast<int>(i)] = rounded(magnitude(map_.scale[i]) * radii[map_.from[i]]);
    if (r.x == r.y && r.y == r.z) return add(SupportKind::kBall, 0, {c.x, c.y, c.z, r.x}, false);
    return add(SupportKind::kEllipsoid, 0, {c.x, c.y, c.z, r.x, r.y, r.z}, false);
}

HalfSpaceRef Placer::cylinder(int axis, Vec3 through, double r) {
    const int i = axis_of(axis);
    const Vec3 c = point(through);
    return add(SupportKind::kCylinder, i, {c[(i + 1) % 3], c[(i + 2) % 3], length(r, (axis + 1) % 3)}, false);
}

HalfSpaceRef Placer::cone(int axis, Vec3 through, double z0, double z1, double r0, double r1) {
    const int i = axis_of(axis);
    const Vec3 c = point(through);
    double a = coordinate(static_cast<std::size_t>(i), z0), b = coordinate(static_cast<std::size_t>(i), z1);
    double ra = length(r0, (axis + 1) % 3), rb = length(r1, (axis + 1) % 3);
    if (a > b) {
        std::swap(a, b);
        std::swap(ra, rb);
    }
    return add(SupportKind::kCone, i, {c[(i + 1) % 3], c[(i + 2) % 3], a, b, ra, rb}, false);
}

HalfSpaceRef Placer::tube(Vec3 p, Vec3 q, double r) {
    const Vec3 a = point(p), b = point(q);
    return add(SupportKind::kTube, 0, {a.x, a.y, a.z, b.x, b.y, b.z, length(r, 0)}, false);
}

HalfSpaceRef Placer::quadric(const std::array<double, 10>& c) {
    std::array<double, 3> k;  // old coordinate from[i] is k[i] times the new coordinate i
    for (std::size_t i = 0; i < 3; ++i) k[i] = 1 / to_double(map_.scale[i]);
    std::array<double, 10> r{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, from = map_.from[i], other = map_.from[j];
        r[i] = c[from] * k[i] * k[i];
        r[i + j + 2] = c[from + other + 2] * k[i] * k[j];
        r[6 + i] = c[6 + from] * k[i];
    }
    r[9] = c[9];
    return add(SupportKind::kQuadric, 0, r, false);
}

HalfSpaceRef Placer::torus(Vec3 centre, double major, double minor) {
    const Vec3 c = point(centre);
    return add(SupportKind::kTorus, axis_of(2), {c.x, c.y, c.z, length(major, 0), length(minor, 0)}, false);
}

HalfSpaceRef Placer::torus_core(Vec3 centre, double major, double minor) {
    const Vec3 c = point(centre);
    return add(SupportKind::kTorusCore, axis_of(2), {c.x, c.y, c.z, length(major, 0), length(minor, 0)}, false);
}

SupportId Placer::edge_plane(int axis, Vec2 a, Vec2 b) {
    if (a == b) return kNoSupport;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (a.x == b.x) return add(SupportKind::kAxisPlane, u, {a.x}, false).support;
    if (a.y == b.y) return add(SupportKind::kAxisPlane, v, {a.y}, false).support;
    if (b.x < a.x) std::swap(a, b);
    return add(SupportKind::kEdgePlane, axis, {a.x, a.y, b.x, b.y}, false).support;
}

SupportId Placer::parabola(int axis, Vec2 a, Vec2 c, Vec2 b) {
    if (std::tie(b.x, b.y) < std::tie(a.x, a.y)) std::swap(a, b);
    return add(SupportKind::kParabola, axis, {a.x, a.y, c.x, c.y, b.x, b.y}, false).support;
}

HalfSpaceRef Placer::turned_side(Vec2 a, Vec2 b) {
    const bool turned = std::tie(b.x, b.y) < std::tie(a.x, a.y);
    if (turned) std::swap(a, b);
    return add(SupportKind::kTurnedSide, 2, {a.x, a.y, b.x, b.y}, turned);
}

HalfSpaceRef Placer::turned_ellipse(Vec2 centre, Vec2 u, Vec2 v) { return add(SupportKind::kTurnedEllipse, 2, {centre.x, centre.y, u.x, v.x, u.y, v.y}, false); }

HalfSpaceRef Placer::turned_parabola(Vec2 a, Vec2 c, Vec2 b) {
    if (std::tie(b.x, b.y) < std::tie(a.x, a.y)) std::swap(a, b);
    return add(SupportKind::kTurnedParabola, 2, {a.x, a.y, c.x, c.y, b.x, b.y}, false);
}

HalfSpaceRef Placer::convex(std::shared_ptr<const ConvexHullBody> body) {
    return add_to(formula_.table.frame_of(frame_, std::move(body)), SupportKind::kConvex, 0, {}, false);
}

SupportId Placer::facet(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (int i = 0; i < 3; ++i)
        if (a[i] == b[i] && b[i] == c[i]) return add(SupportKind::kAxisPlane, i, {a[i]}, false).support;
    return add(SupportKind::kPlanePoints, 0, {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}, false).support;
}

bool Placer::mirrors() const {
    const bool odd = (map_.from[0] + 1) % 3 != map_.from[1];
    return odd != ((map_.scale[0] < 0) != ((map_.scale[1] < 0) != (map_.scale[2] < 0)));
}

HalfSpaceRef Placer::edge_side(int axis, Vec2 a, Vec2 b) {
    // The support's positive side is the right of the edge as edge_plane() writes it; of axis planes the side above.
    const bool outside_is_negative = a.x == b.x ? b.y < a.y : a.y == b.y ? a.x < b.x : b.x < a.x;
    return {edge_plane(axis, a, b), outside_is_negative};
}

HalfSpaceRef Placer::upright_side(Vec2 a, Vec2 b) {
    const int axis = axis_of(2), u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vec3 from = point(Vec3(a, 0)), to = point(Vec3(b, 0));
    const Vec2 p(from[u], from[v]), q(to[u], to[v]);
    // Seen along the frame's axis, the shape's own axis may point the other way.
    const bool flipped = mirrors() != (map_.scale[static_cast<std::size_t>(axis)] < 0);
    return flipped ? edge_side(axis, q, p) : edge_side(axis, p, q);
}

HalfSpaceRef Placer::side(const Vec3& a, const Vec3& b, const Vec3& c) {
    Vec3 p = point(a), q = point(b);
    const Vec3 r = point(c);
    if (mirrors()) std::swap(p, q);
    const SupportId support = facet(p, q, r);
    const Support& s = formula_.table.supports[support];
    return {support, s.kind == SupportKind::kAxisPlane && glm::cross(q - p, r - p)[s.axis] < 0};
}

}  // namespace whittle
