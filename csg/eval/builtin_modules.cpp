// The table of built-in modules and the shortest of them.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "csg/eval/builtin_module_parts.h"

namespace whittle {

bool read_number(const Value& value, double& out) {
    if (!value.is_number() || !std::isfinite(value.number())) return false;
    out = value.number();
    return true;
}

bool read_vec3(const Value& value, Vec3& out, double otherwise) {
    if (!value.is_vector() || (value.size() != 2 && value.size() != 3)) return false;
    Vec3 read{0, 0, otherwise};
    for (std::uint32_t i = 0; i < value.size(); ++i)
        if (!read_number(value[i], read[static_cast<int>(i)])) return false;
    out = read;
    return true;
}

bool read_vec2(const Value& value, Vec2& out) {
    Vec2 read{0};
    if (!value.is_vector() || value.size() != 2 || !read_number(value[0], read.x) || !read_number(value[1], read.y)) return false;
    out = read;
    return true;
}

int read_convexity(const Value& value, int otherwise) {
    if (!value.is_number() || !(std::fabs(value.number()) < 2147483648.0)) return otherwise;
    const int n = static_cast<int>(value.number());
    return n > 0 ? n : otherwise;
}

namespace {

template <class T>
Made plain(ModuleUse& use) {
    (void)use;
    return T{};
}
Made make_group(ModuleUse& use) {
    (void)use;
    return scene::Group{"group"};
}
Made make_minkowski(ModuleUse& use) {
    scene::Minkowski out;
    if (use[0].is_number() && std::fabs(use[0].number()) < 2147483648.0) out.convexity = static_cast<int>(use[0].number());
    return out;
}
Made make_render(ModuleUse& use) { return scene::Render{read_convexity(use[0], 1)}; }
Made make_projection(ModuleUse& use) {
    return scene::Projection{use[0].is_bool() && use[0].boolean(), read_convexity(use[1], 0)};
}
// The methods of the development version; unknown ones are the first.
Made make_roof(ModuleUse& use) {
    scene::Roof out{"voronoi", read_convexity(use[1], 1)};
    if (use[0].is_string()) {
        if (use[0].string() == "straight" || use[0].string() == "voronoi") out.method = std::string(use[0].string());
        else use.warn("Unknown roof method '" + std::string(use[0].string()) + "'. Using 'voronoi'.");
    } else if (!use[0].is_undef()) {
        use.warn("Unable to convert roof(method=" + use.machine.text_of(use[0]) + ") parameter to a string");
    }
    return out;
}

constexpr std::string_view kExtrude = "file layer height origin scale center twist slices";
constexpr std::string_view kExtrudeNamed = "convexity v h segments";
constexpr std::string_view kRevolve = "file layer origin scale";
constexpr std::string_view kRevolveNamed = "convexity angle start a";
constexpr std::string_view kImport = "file layer convexity origin scale";
constexpr std::string_view kImportNamed = "width height filename layername center dpi id";
constexpr std::string_view kExtrudeForm = "linear_extrude(height, center, convexity, twist, slices, scale, v, segments)";
constexpr std::string_view kRevolveForm = "rotate_extrude(angle, convexity, start)";
constexpr std::string_view kImportForm = "import(\"file\", layer, convexity, origin, scale, center=, dpi=)";

// A name as part of a type.
template <std::size_t N>
struct Name {
    char text[N];
    constexpr Name(const char (&s)[N]) { std::copy_n(s, N, text); }  // NOLINT: so that a literal is one
};

template <Name old, Name now, std::optional<scene::What> (*make)(ModuleUse&)>
std::optional<scene::What> renamed(ModuleUse& use) {
    use.machine.say(Severity::kDeprecated, use.place, fmt::format("The {}() module will be removed in future releases. Use {}() instead.", old.text, now.text));
    return make(use);
}

constexpr std::array kModules = std::to_array<BuiltinModule>({
    {"cube", "size center", "", false, make_cube, "cube(size, center)"},
    {"sphere", "r", "d", false, make_sphere, "sphere(r) or sphere(d=)"},
    {"cylinder", "h r1 r2 center", "r d d1 d2", false, make_cylinder, "cylinder(h, r1, r2, center) or cylinder(h, r=) or (h, d=)"},
    {"polyhedron", "points faces convexity", "triangles", false, make_polyhedron, "polyhedron(points, faces, convexity)"},
    {"square", "size center", "", false, make_square, "square(size, center)"},
    {"circle", "r", "d", false, make_circle, "circle(r) or circle(d=)"},
    {"polygon", "points paths convexity", "", false, make_polygon, "polygon(points, paths, convexity)"},
    {"torus", "r1 r2", "d1 d2", false, make_torus, "torus(r1, r2)"},
    {"ellipsoid", "r", "", false, make_ellipsoid, "ellipsoid([x, y, z])"},
    {"halfspace", "n d", "", false, make_halfspace, "halfspace(n, d)"},
    {"quadric", "c", "", false, make_quadric, "quadric([a, b, c, d, e, f, g, h, i, j])"},
    {"capsule", "p q r", "", false, make_capsule, "capsule(p, q, r)"},
    {"roundcube", "size r center", "", false, make_roundcube, "roundcube(size, r, center)"},
    {"union", "", "", true, plain<scene::Union>, "union()"},
    {"difference", "", "", true, plain<scene::Difference>, "difference()"},
    {"intersection", "", "", true, plain<scene::Intersection>, "intersection()"},
    {"hull", "", "", true, plain<scene::Hull>, "hull()"},
    {"minkowski", "convexity", "", true, make_minkowski, "minkowski(convexity)"},
    {"group", "", "", true, make_group, "group()"},
    {"render", "convexity", "", true, make_render, "render(convexity)"},
    {"translate", "v", "", true, make_translate, "translate([x, y, z])"},
    {"rotate", "a v", "", true, make_rotate, "rotate([x, y, z]) or rotate(angle, axis)"},
    {"scale", "v", "", true, make_scale, "scale([x, y, z]) or scale(factor)"},
    {"mirror", "v", "", true, make_mirror, "mirror([x, y, z])"},
    {"multmatrix", "m", "", true, make_multmatrix, "multmatrix(4x4 matrix)"},
    {"resize", "newsize auto convexity", "", true, make_resize, "resize([x, y, z], auto, convexity)"},
    {"color", "c alpha", "", true, make_color, "color(c, alpha)"},
    {"linear_extrude", kExtrude, kExtrudeNamed, true, make_linear_extrude, kExtrudeForm},
    {"dxf_linear_extrude", kExtrude, kExtrudeNamed, true, renamed<"dxf_linear_extrude", "linear_extrude", make_linear_extrude>, kExtrudeForm},
    {"rotate_extrude", kRevolve, kRevolveNamed, true, make_rotate_extrude, kRevolveForm},
    {"dxf_rotate_extrude", kRevolve, kRevolveNamed, true, renamed<"dxf_rotate_extrude", "rotate_extrude", make_rotate_extrude>, kRevolveForm},
    {"offset", "r", "delta chamfer", true, make_offset, "offset(r) or offset(delta=, chamfer=)"},
    {"projection", "cut", "convexity", true, make_projection, "projection(cut)"},
    {"fill", "", "", true, plain<scene::Fill>, "fill()"},
    {"roof", "method", "convexity", true, make_roof, "roof(method)"},
    {"text", "text size font", "direction language script halign valign spacing", false, make_text, "text(\"text\", size, font, halign=, valign=, spacing=, direction=, language=, script=)"},
    {"import", kImport, kImportNamed, false, make_import, kImportForm},
    {"import_stl", kImport, kImportNamed, false, renamed<"import_stl", "import", make_import>, kImportForm},
    {"import_off", kImport, kImportNamed, false, renamed<"import_off", "import", make_import>, kImportForm},
    {"import_dxf", kImport, kImportNamed, false, renamed<"import_dxf", "import", make_import>, kImportForm},
    {"surface", "file center convexity", "invert", false, make_surface, "surface(\"file\", center, convexity)"},
    {"material", "preset", "color roughness metal ior transmission absorption dispersion emission priority", true, make_material,
     "material(\"preset\", color=, roughness=, metal=, ior=, transmission=, absorption=, dispersion=, emission=, priority=)"},
    {"part", "name", "", true, make_part, "part(\"name\")"},
    {"moving", "translate rotate scale", "", true, make_moving, "moving(translate, rotate, scale)"},
    {"light", "p color power r", "", false, make_light, "light(p, color, power, r)"},
    {"sun", "direction color irradiance angle", "", false, make_sun, "sun(direction, color, irradiance, angle)"},
    {"area_light", "p u v color power", "", false, make_area_light, "area_light(p, u, v, color, power)"},
    {"environment", "color intensity rotate", "file", false, make_environment, "environment(color or file, intensity, rotate)"},
    {"camera", "eye target up fov aperture focus projection exposure blades", "", false, make_camera,
     "camera(eye, target, up, fov, aperture, focus, projection, exposure, blades)"},
});

}  // namespace

void ModuleUse::warn(std::string text) const { machine.warn(place, std::move(text), "expected " + std::string(signature)); }

std::span<const BuiltinModule> builtin_modules() { return kModules; }

}  // namespace whittle
