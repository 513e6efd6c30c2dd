// matter.h — material, light and lens as the author wrote them. Presets and scattering live in tracer/light.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "csg/base/vec.h"
#include "csg/lang/source.h"

namespace whittle {

// Every parameter the author may name; unset ones are filled by an inner material(), else by the preset.
// `color` is sRGB 0..1 with alpha, a component below 0 is not set; `absorption` and `emission` are linear Rec.709; `absorption` per mm.
struct Material {
    std::optional<std::string> preset;
    std::optional<Vec4> color;
    std::optional<double> roughness, metal, ior, transmission, dispersion, priority;
    std::optional<Vec3> absorption, emission;

    bool names_surface() const { return color || roughness || metal; }
    bool operator==(const Material&) const = default;
};

// `outer` wins parameter by parameter; a component of a colour below 0 was not set and shows the inner one.
inline std::optional<Vec4> nested(const std::optional<Vec4>& outer, const std::optional<Vec4>& inner) {
    if (!outer || !inner) return outer ? outer : inner;
    Vec4 c = *outer;
    for (int i = 0; i < 4; ++i)
        if (c[i] < 0) c[i] = (*inner)[i];
    return c;
}
inline Material nested(const Material& outer, const Material& inner) {
    const auto first = [](const auto& a, const auto& b) { return a ? a : b; };
    return {first(outer.preset, inner.preset),         nested(outer.color, inner.color),
            first(outer.roughness, inner.roughness),   first(outer.metal, inner.metal),
            first(outer.ior, inner.ior),               first(outer.transmission, inner.transmission),
            first(outer.dispersion, inner.dispersion), first(outer.priority, inner.priority),
            first(outer.absorption, inner.absorption), first(outer.emission, inner.emission)};
}

// Can light enter what is made of it? Then its place among overlapping solids matters (numerics: labels are not sets).
inline bool is_clear(const Material& material) {
    const std::string preset = material.preset.value_or("");
    return material.transmission.value_or(0) > 0 || material.priority || preset == "glass" || preset == "water" || preset == "diamond";
}

// Lights in world space, transformed when evaluated. Colours sRGB 0..1. An unset power: "lights a white matte surface at the
// model's centre to white". Angles in degrees.
struct PointLight { Vec3 p{0}; Vec3 color{1}; std::optional<double> power; double radius = 0; };
struct SunLight { Vec3 direction{0, 0, -1}; Vec3 color{1}; std::optional<double> irradiance; double angle_deg = 0; };
struct AreaLight { Vec3 p{0}; Vec3 u{1, 0, 0}; Vec3 v{0, 1, 0}; Vec3 color{1}; std::optional<double> power; };
struct EnvironmentLight { Vec3 color{1}; std::string file; double intensity = 1; Vec3 rotate_deg{0}; };

struct Light {
    std::variant<PointLight, SunLight, AreaLight, EnvironmentLight> what;
    SourcePlace place;
};

// `fov_deg` vertical; `aperture` a diameter in mm (0: pinhole), a polygon of `blades` corners where these are 3 or more; unset focus: |target - eye|; exposure in stops.
struct Camera {
    Vec3 eye{0}, target{0}, up{0, 0, 1};
    double fov_deg = 22.5;
    double aperture = 0;
    int blades = 0;
    std::optional<double> focus;
    bool orthographic = false;
    double exposure = 0;
    SourcePlace place;
};

}  // namespace whittle
