#include "csg/solid/hash.h"

#include <bit>
#include <string_view>

#include "csg/solid/convex_body.h"

namespace whittle {
namespace {

// One 64-bit word at a time. Source of the finaliser: Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators (2014).
class Hasher {
public:
    void add(std::uint64_t word) {
        std::uint64_t x = state_ ^ (word + 0x9E3779B97F4A7C15u + (state_ << 6) + (state_ >> 2));
        x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
        x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
        state_ = x ^ (x >> 31);
    }
    void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
    void add(Vec2 v) { add(v.x), add(v.y); }
    void add(Vec3 v) { add(v.x), add(v.y), add(v.z); }
    void add(Vec4 v) { add(v.x), add(v.y), add(v.z), add(v.w); }
    void add(std::string_view text) {
        add(std::uint64_t{text.size()});
        for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    }
    void add(int x) { add(static_cast<std::uint64_t>(x)); }
    void add(const Placement& placement) {
        for (const double x : placement.m) add(x);
    }
    template <class T>
    void add(const std::optional<T>& x) {
        add(std::uint64_t{x.has_value()});
        if (x) add(*x);
    }
    void add(const std::optional<std::string>& x) { add(std::string_view(x ? *x : std::string())); }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0x243F6A8885A308D3u;
};

void add_numbers(Hasher& h, const FacetList& mesh) {
    for (const Vec3& p : mesh.points) h.add(p);
    for (const auto& facet : mesh.facets) {
        h.add(std::uint64_t{facet.size()});
        for (const std::uint32_t i : facet) h.add(std::uint64_t{i});
    }
}

struct AddShape {
    Hasher& h;

    void operator()(const shape::Box& s) const { h.add(s.lo), h.add(s.hi); }
    void operator()(const shape::Ellipsoid& s) const { h.add(s.radii); }
    void operator()(const shape::Frustum& s) const { h.add(s.z0), h.add(s.z1), h.add(s.r0), h.add(s.r1); }
    void operator()(const shape::Torus& s) const { h.add(s.major), h.add(s.minor); }
    void operator()(const shape::HalfSpace& s) const { h.add(s.n), h.add(s.d); }
    void operator()(const shape::Quadric& s) const {
        for (const double c : s.c) h.add(c);
    }
    void operator()(const shape::Capsule& s) const { h.add(s.p), h.add(s.q), h.add(s.r); }
    void operator()(const shape::RoundBox& s) const { h.add(s.lo), h.add(s.hi), h.add(s.r); }
    void operator()(const shape::ConvexBody& s) const {
        for (const ConvexPart& part : s.hull->parts) {
            h.add(part.centre);
            h.add(std::uint64_t{part.images.size()});
            for (const BallImage& image : part.images) h.add(image.u), h.add(image.v), h.add(image.w);
        }
    }
    void operator()(const shape::FacetedBall& s) const { h.add(s.r), h.add(s.n); }
    void operator()(const shape::FacetedFrustum& s) const { h.add(s.z0), h.add(s.z1), h.add(s.r0), h.add(s.r1), h.add(s.n); }
    void operator()(const shape::Polyhedron& s) const { add_numbers(h, *s.mesh); }
    void operator()(const shape::Extrusion& s) const {
        h.add(std::uint64_t{s.profile}), h.add(s.z0), h.add(s.z1), h.add(s.twist_deg), h.add(s.scale_top), h.add(s.slices);
    }
    void operator()(const shape::Revolution& s) const {
        h.add(std::uint64_t{s.profile}), h.add(s.start_deg), h.add(s.angle_deg), h.add(s.fragments);
    }
    void operator()(const shape::Disc& s) const { h.add(s.r); }
    void operator()(const shape::Rectangle& s) const { h.add(s.lo), h.add(s.hi); }
    void operator()(const shape::Polygon& s) const {
        for (const auto& contour : *s.contours) {
            h.add(std::uint64_t{contour.size()});
            for (const Vec2& p : contour) h.add(p);
        }
        if (s.section != kEmptyNode) h.add(std::uint64_t{s.section}), h.add(s.deviation);
    }
    void operator()(const shape::ParabolicSegment& s) const { h.add(s.a), h.add(s.c), h.add(s.b); }
};

// x + 0 is x, but 0 for -0.
struct DropNegativeZero {
    static void fix(double& x) { x += 0.0; }
    static void fix(Vec2& v) { v += Vec2(0.0); }
    static void fix(Vec3& v) { v += Vec3(0.0); }

    void operator()(shape::Box& s) const { fix(s.lo), fix(s.hi); }
    void operator()(shape::Ellipsoid&) const {}
    void operator()(shape::Frustum& s) const { fix(s.z0), fix(s.z1), fix(s.r0), fix(s.r1); }
    void operator()(shape::Torus& s) const { fix(s.major); }
    void operator()(shape::HalfSpace& s) const { fix(s.n), fix(s.d); }
    void operator()(shape::Quadric& s) const {
        for (double& c : s.c) fix(c);
    }
    void operator()(shape::Capsule& s) const { fix(s.p), fix(s.q); }
    void operator()(shape::RoundBox& s) const { fix(s.lo), fix(s.hi), fix(s.r); }
    void operator()(shape::ConvexBody&) const {}  // has none
    void operator()(shape::FacetedBall&) const {}
    void operator()(shape::FacetedFrustum& s) const { fix(s.z0), fix(s.z1), fix(s.r0), fix(s.r1); }
    void operator()(shape::Polyhedron& s) const {
        auto copy = std::make_shared<FacetList>(*s.mesh);
        for (Vec3& p : copy->points) fix(p);
        s.mesh = std::move(copy);
    }
    void operator()(shape::Extrusion& s) const { fix(s.z0), fix(s.z1), fix(s.twist_deg), fix(s.scale_top); }
    void operator()(shape::Revolution& s) const { fix(s.start_deg), fix(s.angle_deg); }
    void operator()(shape::Disc&) const {}
    void operator()(shape::Rectangle& s) const { fix(s.lo), fix(s.hi); }
    void operator()(shape::Polygon& s) const {
        auto copy = std::make_shared<std::vector<std::vector<Vec2>>>(*s.contours);
        for (auto& contour : *copy)
            for (Vec2& p : contour) fix(p);
        s.contours = std::move(copy);
    }
    void operator()(shape::ParabolicSegment& s) const { fix(s.a), fix(s.c), fix(s.b); }
};

}  // namespace

std::uint64_t hash_of(const Shape& shape) {
    Hasher h;
    h.add(std::uint64_t{shape.index()});
    std::visit(AddShape{h}, shape);
    return h.value();
}

std::uint64_t hash_of(const Use& use) {
    Hasher h;
    h.add(std::uint64_t{use.node} << 32 | use.label);
    h.add(std::uint64_t{use.motion});
    h.add(use.placement);
    return h.value();
}

std::uint64_t hash_of(const Combination& combination) {
    Hasher h;
    h.add(static_cast<std::uint64_t>(combination.op) + 100);  // apart from shapes
    for (const Use& use : combination.operands) h.add(hash_of(use));
    return h.value();
}

std::uint64_t hash_of(const Label& label) {
    Hasher h;
    const Material& m = label.material;
    h.add(m.preset), h.add(m.color), h.add(m.roughness), h.add(m.metal), h.add(m.ior), h.add(m.transmission), h.add(m.dispersion);
    h.add(m.priority), h.add(m.absorption), h.add(m.emission);
    h.add(std::uint64_t{label.place.file} << 32 | label.place.line);
    h.add(std::uint64_t{label.place.column});
    h.add(std::string_view(label.part));
    return h.value();
}

std::uint64_t hash_of(const Motion& motion) {
    Hasher h;
    h.add(motion.start);
    h.add(motion.end);
    return h.value();
}

Shape without_negative_zero(Shape shape) {
    std::visit(DropNegativeZero{}, shape);
    return shape;
}

}  // namespace whittle
