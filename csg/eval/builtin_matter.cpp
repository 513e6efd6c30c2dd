// Built-in modules that OpenSCAD does not have: matter, light, lens, parts and motion.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "csg/base/degrees.h"
#include "csg/eval/builtin_module_parts.h"
#include "csg/eval/colors.h"

namespace whittle {
namespace {

constexpr std::array<std::string_view, 12> kPresets{"matte", "plastic", "glass", "water", "diamond", "mirror", "gold", "silver", "copper", "steel", "brushed", "emissive"};

void complain(ModuleUse& use, const char* what, const Value& v, const char* wanted) {
    use.warn(fmt::format("Unable to convert {} = {} to {}", what, use.machine.text_of(v), wanted));
}

std::optional<double> number(ModuleUse& use, const Value& v, const char* what) {
    double out = 0;
    if (read_number(v, out)) return out;
    if (!v.is_undef()) complain(use, what, v, "a number");
    return std::nullopt;
}

std::optional<Vec3> triple(ModuleUse& use, const Value& v, const char* what) {
    Vec3 out{0};
    if (v.is_number() && std::isfinite(v.number())) return Vec3(v.number());
    if (read_vec3(v, out, 0)) return out;
    if (!v.is_undef()) complain(use, what, v, "a vec3 of numbers");
    return std::nullopt;
}

Vec3 light_color(ModuleUse& use, const Value& v) {
    const std::optional<Vec4> c = read_color(use, v);
    return c ? Vec3(*c) : Vec3(1);
}

}  // namespace

Made make_material(ModuleUse& use) {
    Material m;
    if (use[0].is_string()) {
        const std::string name(use[0].string());
        if (std::find(kPresets.begin(), kPresets.end(), name) != kPresets.end()) {
            m.preset = name;
        } else {
            std::string list;
            for (const std::string_view p : kPresets) list += (list.empty() ? "" : ", ") + std::string(p);
            const std::optional<std::string> near = nearest_name(name, {kPresets.begin(), kPresets.end()});
            use.machine.say(Severity::kError, use.place, fmt::format("Unknown material \"{}\": the presets are {}", name, list),
                            near ? "did you mean \"" + *near + "\"?" : std::string());
        }
    } else if (!use[0].is_undef()) {
        complain(use, "material(preset)", use[0], "a string");
    }
    m.color = read_color(use, use[1]);
    m.roughness = number(use, use[2], "material(roughness)");
    m.metal = number(use, use[3], "material(metal)");
    m.ior = number(use, use[4], "material(ior)");
    m.transmission = number(use, use[5], "material(transmission)");
    m.absorption = triple(use, use[6], "material(absorption)");
    m.dispersion = number(use, use[7], "material(dispersion)");
    m.emission = triple(use, use[8], "material(emission)");
    m.priority = number(use, use[9], "material(priority)");
    return scene::Matter{m};
}

Made make_part(ModuleUse& use) {
    if (use[0].is_string()) return scene::Part{std::string(use[0].string())};
    complain(use, "part(name)", use[0], "a string");
    return scene::Part{};
}

// At the end of the shutter: scaled, turned, then moved.
Made make_moving(ModuleUse& use) {
    scene::Moving out;
    const std::optional<Vec3> move = triple(use, use[0], "moving(translate)");
    const std::optional<Vec3> scale = triple(use, use[2], "moving(scale)");
    if (scale) out.end = Placement{{scale->x, 0, 0, 0, 0, scale->y, 0, 0, 0, 0, scale->z, 0}};
    if (!use[1].is_undef()) out.end = read_rotation(use, use[1], Value()) * out.end;
    if (move) out.end = Placement::translation(*move) * out.end;
    return out;
}

Made make_light(ModuleUse& use) {
    PointLight light;
    light.p = apply_to_point(use.machine.placement(), triple(use, use[0], "light(p)").value_or(Vec3(0)));
    light.color = light_color(use, use[1]);
    light.power = number(use, use[2], "light(power)");
    light.radius = number(use, use[3], "light(r)").value_or(0);
    use.machine.add_light({light, use.place});
    return std::nullopt;
}

Made make_sun(ModuleUse& use) {
    SunLight light;
    light.direction = apply_to_direction(use.machine.placement(), triple(use, use[0], "sun(direction)").value_or(light.direction));
    light.color = light_color(use, use[1]);
    light.irradiance = number(use, use[2], "sun(irradiance)");
    light.angle_deg = number(use, use[3], "sun(angle)").value_or(0);
    use.machine.add_light({light, use.place});
    return std::nullopt;
}

Made make_area_light(ModuleUse& use) {
    AreaLight light;
    const Placement& placement = use.machine.placement();
    light.p = apply_to_point(placement, triple(use, use[0], "area_light(p)").value_or(light.p));
    light.u = apply_to_direction(placement, triple(use, use[1], "area_light(u)").value_or(light.u));
    light.v = apply_to_direction(placement, triple(use, use[2], "area_light(v)").value_or(light.v));
    light.color = light_color(use, use[3]);
    light.power = number(use, use[4], "area_light(power)");
    use.machine.add_light({light, use.place});
    return std::nullopt;
}

Made make_environment(ModuleUse& use) {
    EnvironmentLight light;
    // The first argument is a color or the name of a file.
    if (use[0].is_string() && !color_of_text(use[0].string()) && use[0].string().find('.') != std::string_view::npos) light.file = use[0].string();
    else light.color = light_color(use, use[0]);
    if (use[3].is_string()) light.file = use[3].string();
    light.intensity = number(use, use[1], "environment(intensity)").value_or(1);
    if (use[2].is_number()) light.rotate_deg = {0, 0, use[2].number()};
    else light.rotate_deg = triple(use, use[2], "environment(rotate)").value_or(Vec3(0));
    use.machine.add_light({light, use.place});
    return std::nullopt;
}

Made make_camera(ModuleUse& use) {
    Camera camera;
    const Placement& placement = use.machine.placement();
    camera.eye = apply_to_point(placement, triple(use, use[0], "camera(eye)").value_or(Vec3(0)));
    camera.target = apply_to_point(placement, triple(use, use[1], "camera(target)").value_or(Vec3(0)));
    camera.up = apply_to_direction(placement, triple(use, use[2], "camera(up)").value_or(camera.up));
    camera.fov_deg = number(use, use[3], "camera(fov)").value_or(camera.fov_deg);
    camera.aperture = number(use, use[4], "camera(aperture)").value_or(0);
    camera.focus = number(use, use[5], "camera(focus)");
    if (use[6].is_string()) {
        const std::string_view p = use[6].string();
        camera.orthographic = !p.empty() && (p[0] == 'o' || p[0] == 'O');
        if (!camera.orthographic && p != "p" && p != "perspective") complain(use, "camera(projection)", use[6], "\"perspective\" or \"orthographic\"");
    }
    camera.exposure = number(use, use[7], "camera(exposure)").value_or(0);
    const double blades = number(use, use[8], "camera(blades)").value_or(0);
    constexpr double kMostBlades = 1000;
    camera.blades = blades >= 3 ? static_cast<int>(std::min(blades, kMostBlades)) : 0;
    camera.place = use.place;
    use.machine.set_camera(camera);
    return std::nullopt;
}

}  // namespace whittle
