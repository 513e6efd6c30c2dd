// Built-in modules without children: solids and flat shapes.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/eval/builtin_module_parts.h"

namespace whittle {
namespace {

bool truth_if_bool(const Value& v) { return v.is_bool() && v.boolean(); }

// A radius by its own name or as half a diameter, which wins; unset where neither is a number.
std::optional<double> radius(ModuleUse& use, const Value& r, const Value& d, const char* r_name, const char* d_name) {
    if (d.is_number()) {
        if (r.is_number()) use.warn(fmt::format("Ignoring radius variable '{}' as diameter '{}' is defined too.", r_name, d_name));
        return d.number() / 2;
    }
    if (r.is_number()) return r.number();
    return std::nullopt;
}

Vec3 three(ModuleUse& use, const Value& v, Vec3 otherwise, const char* what) {
    Vec3 out = otherwise;
    if (!v.is_undef() && !read_vec3(v, out, 0)) use.warn(fmt::format("Unable to convert {} = {} to a vec3 of numbers", what, use.machine.text_of(v)));
    return out;
}

double one(ModuleUse& use, const Value& v, double otherwise, const char* what) {
    if (v.is_undef()) return otherwise;
    if (v.is_number()) return v.number();
    use.warn(fmt::format("Unable to convert {} = {} to a number", what, use.machine.text_of(v)));
    return otherwise;
}

std::vector<std::vector<std::int64_t>> index_lists(const Value& lists) {
    std::vector<std::vector<std::int64_t>> out;
    if (!lists.is_vector()) return out;
    for (std::uint32_t i = 0; i < lists.size(); ++i) {
        if (!lists[i].is_vector()) continue;
        std::vector<std::int64_t>& list = out.emplace_back();
        for (std::uint32_t k = 0; k < lists[i].size(); ++k) {
            const Value& v = lists[i][k];
            list.push_back(v.is_number() && std::fabs(v.number()) < 9e15 ? static_cast<std::int64_t>(v.number()) : 0);
        }
    }
    return out;
}

}  // namespace

Made make_cube(ModuleUse& use) {
    scene::Cube out;
    const Value& size = use[0];
    if (size.is_number()) {
        out.size = Vec3(size.number());
    } else if (!size.is_undef()) {
        bool good = size.is_vector() && size.size() == 3;
        for (std::uint32_t i = 0; i < 3 && good; ++i) {  // what stands before one that is no number counts
            good = size[i].is_number();
            if (good) out.size[static_cast<int>(i)] = size[i].number();
        }
        if (!good) use.warn(fmt::format("Unable to convert cube(size={}, ...) parameter to a number or a vec3 of numbers", use.machine.text_of(size)));
    }
    out.center = truth_if_bool(use[1]);
    return out;
}

Made make_sphere(ModuleUse& use) { return scene::Sphere{radius(use, use[0], use[1], "r", "d").value_or(1)}; }

Made make_cylinder(ModuleUse& use) {
    scene::Cylinder out;
    if (use[0].is_number()) out.h = use[0].number();
    const std::optional<double> r = radius(use, use[4], use[5], "r", "d");
    const std::optional<double> r1 = radius(use, use[1], use[6], "r1", "d1");
    const std::optional<double> r2 = radius(use, use[2], use[7], "r2", "d2");
    if (r && (r1 || r2)) use.warn("Cylinder parameters ambiguous");
    out.r1 = r1 ? *r1 : r.value_or(1);
    out.r2 = r2 ? *r2 : r.value_or(1);
    out.center = truth_if_bool(use[3]);
    return out;
}

Made make_polyhedron(ModuleUse& use) {
    scene::Polyhedron out;
    const Value& points = use[0];
    const Value& faces = use[1].is_undef() && !use[3].is_undef() ? use[3] : use[1];
    if (use[1].is_undef() && !use[3].is_undef())
        use.machine.say(Severity::kDeprecated, {}, "polyhedron(triangles=[]) will be removed in future releases. Use polyhedron(faces=[]) instead.");
    if (points.is_vector())
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            Vec3 p{0};
            if (!points[i].is_vector() || points[i].size() != 3 || !read_vec3(points[i], p, 0)) {
                use.warn(fmt::format("Unable to convert points[{}] = {} to a vec3 of numbers", i, use.machine.text_of(points[i])));
                out.points.clear();
                break;
            }
            out.points.push_back(p);
        }
    out.faces = index_lists(faces);
    out.given_points = points.is_vector() && out.points.size() == points.size();
    out.given_faces = faces.is_vector();
    out.convexity = read_convexity(use[2], 1);
    return out;
}

Made make_square(ModuleUse& use) {
    scene::Square out;
    const Value& size = use[0];
    if (size.is_number()) {
        out.size = Vec2(size.number());
    } else if (!size.is_undef()) {
        const bool good = size.is_vector() && size.size() == 2 && size[0].is_number() && size[1].is_number();
        if (good) out.size = {size[0].number(), size[1].number()};
        else use.warn(fmt::format("Unable to convert square(size={}, ...) parameter to a number or a vec2 of numbers", use.machine.text_of(size)));
    }
    out.center = truth_if_bool(use[1]);
    return out;
}

Made make_circle(ModuleUse& use) { return scene::Circle{radius(use, use[0], use[1], "r", "d").value_or(1)}; }

Made make_polygon(ModuleUse& use) {
    scene::Polygon out;
    const Value& points = use[0];
    if (points.is_vector())
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            Vec2 p{0};
            if (!read_vec2(points[i], p)) {
                use.warn(fmt::format("Unable to convert points[{}] = {} to a vec2 of numbers", i, use.machine.text_of(points[i])));
                out.points.clear();
                break;
            }
            out.points.push_back(p);
        }
    out.paths = index_lists(use[1]);
    out.given_points = points.is_vector() && out.points.size() == points.size();
    out.given_paths = use[1].is_vector();
    out.convexity = read_convexity(use[2], 1);
    return out;
}

Made make_torus(ModuleUse& use) {
    scene::Torus out;
    out.r1 = radius(use, use[0], use[2], "r1", "d1").value_or(out.r1);
    out.r2 = radius(use, use[1], use[3], "r2", "d2").value_or(out.r2);
    return out;
}

Made make_ellipsoid(ModuleUse& use) {
    if (use[0].is_number()) return scene::Ellipsoid{Vec3(use[0].number())};
    return scene::Ellipsoid{three(use, use[0], Vec3(1), "ellipsoid(r)")};
}

Made make_halfspace(ModuleUse& use) {
    return scene::HalfSpace{three(use, use[0], {0, 0, 1}, "halfspace(n)"), one(use, use[1], 0, "halfspace(d)")};
}

Made make_quadric(ModuleUse& use) {
    scene::Quadric out;
    bool good = use[0].is_vector() && use[0].size() == out.c.size();
    for (std::uint32_t i = 0; good && i < out.c.size(); ++i) good = read_number(use[0][i], out.c[i]);
    if (good) return out;
    use.warn(fmt::format("Unable to convert quadric({}) parameter to a list of 10 numbers", use.machine.text_of(use[0])));
    return std::nullopt;
}

Made make_capsule(ModuleUse& use) {
    return scene::Capsule{three(use, use[0], Vec3(0), "capsule(p)"), three(use, use[1], {0, 0, 1}, "capsule(q)"), one(use, use[2], 1, "capsule(r)")};
}

Made make_roundcube(ModuleUse& use) {
    scene::RoundCube out;
    out.size = use[0].is_number() ? Vec3(use[0].number()) : three(use, use[0], Vec3(1), "roundcube(size)");
    out.r = one(use, use[1], 0, "roundcube(r)");
    out.center = truth_if_bool(use[2]);
    return out;
}

}  // namespace whittle
