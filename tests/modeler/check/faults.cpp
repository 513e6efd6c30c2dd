#include "tests/modeler/check/faults.h"

#include <algorithm>
#include <cmath>

#include "tests/modeler/check/check_solids.h"

namespace whittle::test {

namespace {

using Dice = std::mt19937_64;

double between(Dice& random, double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random); }
Vec3 direction(Dice& random) {
    const double z = between(random, -1, 1), phi = between(random, 0, 2 * M_PI), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}
Vec3 normal_of(const Mesh& m, const Triangle& t) { return glm::cross(m.points[t[1]] - m.points[t[0]], m.points[t[2]] - m.points[t[0]]); }
std::size_t any_triangle(const Mesh& m, Dice& random) { return random() % m.triangles.size(); }

Mesh cuboid(Vec3 lo, Vec3 hi, bool outward) {
    Mesh m;
    for (int k = 0; k < 8; ++k) m.points.push_back({k & 1 ? hi.x : lo.x, k & 2 ? hi.y : lo.y, k & 4 ? hi.z : lo.z});
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    if (!outward)
        for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
    return m;
}

Mesh with(Mesh mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
    for (const Triangle& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    mesh.leaf.clear();
    return mesh;
}
template <class Move>
Mesh moved(Mesh mesh, const Move& move) {
    for (Vec3& p : mesh.points) p = move(p);
    return mesh;
}
Mesh without(Mesh mesh, const std::function<bool(const Triangle&)>& goes) {
    std::erase_if(mesh.triangles, goes);
    mesh.leaf.clear();
    return mesh;
}
Mesh of_other(const Subject& s, const SubjectChanges& changes) { return subject(s.made.tolerance_mm, changes).made.mesh; }

// A corner pulled along the sum of its facets' normals.
Mesh pulled(const Subject& s, double by, Dice& random) {
    Mesh m = s.made.mesh;
    const auto v = static_cast<std::uint32_t>(random() % m.points.size());
    Vec3 n{0};
    for (const Triangle& t : m.triangles)
        if (t[0] == v || t[1] == v || t[2] == v) n += glm::normalize(normal_of(m, t));
    m.points[v] += by * glm::normalize(n);
    return m;
}

// Well within the box, below the ball and beside the bore.
Vec3 inside_box(Dice& random) {
    const Vec3 axis = apply_to_direction(tilted(90), {0, 0, 1});
    while (true) {
        const Vec3 p{between(random, -3.4, 3.4), between(random, -3.4, 3.4), between(random, -3.4, 1.5)};
        if (glm::length(p - glm::dot(p, axis) * axis) > 1.4) return p;
    }
}

}  // namespace

Subject subject(double tolerance_mm, const SubjectChanges& c) {
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{Vec3(-4), Vec3(4)});
    const Use bore = use(b.shape(shape::Frustum{-9, 9, c.bore, c.bore}), tilted(90));
    const NodeId hollow = !c.has_bore ? box : c.swapped ? b.combine(SetOp::kDifference, {bore, use(box)}) : b.combine(SetOp::kDifference, {use(box), bore});
    NodeId whole = hollow;
    if (c.has_ball) whole = b.combine(SetOp::kUnion, {use(hollow), use(b.shape(shape::Ellipsoid{Vec3(c.ball)}), Placement::translation(c.ball_at))});
    Subject s{b.finish(use(whole)), {}};
    MeshOptions options;
    options.tolerance_mm = tolerance_mm;
    MeshControl control;
    auto made = mesh_solid(s.solid, options, control);
    REQUIRE(made);
    s.made = std::move(*made);
    return s;
}

const std::vector<NamedFault>& faults() {
    static const std::vector<NamedFault> list{
        {"a corner pulled out", [](const Subject& s, double size, Dice& random) { return pulled(s, size, random); }},
        {"a corner pushed in", [](const Subject& s, double size, Dice& random) { return pulled(s, -size, random); }},
        {"a flipped facet", [](const Subject& s, double, Dice& random) {
             Mesh m = s.made.mesh;
             Triangle& t = m.triangles[any_triangle(m, random)];
             std::swap(t[1], t[2]);
             return m;
         }},
        {"a missing facet", [](const Subject& s, double, Dice& random) {
             Mesh m = s.made.mesh;
             m.triangles.erase(m.triangles.begin() + static_cast<std::ptrdiff_t>(any_triangle(m, random)));
             return m;
         }},
        {"a hole around a corner", [](const Subject& s, double, Dice& random) {
             const auto v = static_cast<std::uint32_t>(random() % s.made.mesh.points.size());
             return without(s.made.mesh, [v](const Triangle& t) { return t[0] == v || t[1] == v || t[2] == v; });
         }},
        {"an inner film", [](const Subject& s, double size, Dice& random) {
             const double z = between(random, -3.5, 1.5);
             return with(s.made.mesh, cuboid({-3.5, -3.5, z}, {3.5, 3.5, z + size}, false));
         }},
        {"a film of no thickness", [](const Subject& s, double, Dice& random) {
             const double z = between(random, -3.5, 1.5);
             return with(s.made.mesh, cuboid({-3.5, -3.5, z}, {3.5, 3.5, z}, true));
         }},
        {"a film outside", [](const Subject& s, double size, Dice& random) {
             const double z = between(random, -9, -4.5);
             return with(s.made.mesh, cuboid({-3, -3, z}, {3, 3, z + size}, true));
         }},
        {"a bubble", [](const Subject& s, double size, Dice& random) {
             const Vec3 p = inside_box(random);
             return with(s.made.mesh, cuboid(p, p + 4 * size, false));
         }},
        {"a lump in the air", [](const Subject& s, double size, Dice& random) {
             const Vec3 p = 9.5 * direction(random);
             return with(s.made.mesh, cuboid(p, p + 4 * size, true));
         }},
        {"a shifted whole", [](const Subject& s, double size, Dice& random) {
             const Vec3 by = 2 * size * direction(random);
             return moved(s.made.mesh, [&](Vec3 p) { return p + by; });
         }},
        {"a shifted part", [](const Subject& s, double size, Dice& random) { return of_other(s, {3, 1, true, true, false, Vec3{0, 0, 5} + 2 * size * direction(random)}); }},
        {"a wrong size", [](const Subject& s, double size, Dice& random) {
             const double by = 1 + (random() % 2 == 0 ? 1 : -1) * size / 4;
             return moved(s.made.mesh, [&](Vec3 p) { return p * by; });
         }},
        {"a wrong size along one axis", [](const Subject& s, double size, Dice& random) {
             const auto k = static_cast<int>(random() % 3);
             return moved(s.made.mesh, [&](Vec3 p) { p[k] *= 1 + size / 4; return p; });
         }},
        {"a turned whole", [](const Subject& s, double size, Dice& random) {
             const auto k = static_cast<int>(random() % 3);
             const double angle = size / 4;
             return moved(s.made.mesh, [&](Vec3 p) {
                 const double x = p[(k + 1) % 3], y = p[(k + 2) % 3];
                 p[(k + 1) % 3] = x * std::cos(angle) - y * std::sin(angle);
                 p[(k + 2) % 3] = x * std::sin(angle) + y * std::cos(angle);
                 return p;
             });
         }},
        {"a wrong radius of a ball", [](const Subject& s, double size, Dice& random) { return of_other(s, {3 + (random() % 2 == 0 ? 1 : -1) * size}); }},
        {"a wrong radius of a hole", [](const Subject& s, double size, Dice& random) { return of_other(s, {3, 1 + (random() % 2 == 0 ? 1 : -1) * size}); }},
        {"a missing hole", [](const Subject& s, double, Dice&) { return of_other(s, {3, 1, false}); }},
        {"a missing part", [](const Subject& s, double, Dice&) { return of_other(s, {3, 1, true, false}); }},
        {"swapped operands", [](const Subject& s, double, Dice&) { return of_other(s, {3, 1, true, true, true}); }},
        {"a mirrored whole", [](const Subject& s, double, Dice&) {
             Mesh m = moved(s.made.mesh, [](Vec3 p) { return Vec3(p.x, p.y, -p.z); });
             for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
             return m;
         }},
        {"an inverted mesh", [](const Subject& s, double, Dice&) {
             Mesh m = s.made.mesh;
             for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
             return m;
         }},
        {"a dropped shell", [](const Subject& s, double, Dice&) { return without(s.made.mesh, [](const Triangle&) { return true; }); }},
        {"a mesh twice", [](const Subject& s, double size, Dice& random) {
             const Vec3 by = 2 * size * direction(random);
             return with(s.made.mesh, moved(s.made.mesh, [&](Vec3 p) { return p + by; }));
         }},
    };
    return list;
}

}  // namespace whittle::test
