#include "tracer/light/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "tracer/image/tone.h"

namespace whittle {

namespace {

struct Preset {
    std::string_view name;
    Vec3 color;  // linear
    double roughness, metal, ior, transmission, abbe;
    double emission;
};

// Metals: reflectance at normal incidence in linear Rec.709 of the pure metals (values as tabulated from n and k by N. Hoffman,
// Physics and Math of Shading, 2013). Indices and Abbe numbers: crown glass BK7 rounded to the customary 1.5, water and diamond at the sodium line.
constexpr Vec3 kNone{-1};  // OpenSCAD's colour
constexpr std::array<Preset, 12> kPresets{{{"matte", kNone, 1, 0, 1, 0, 0, 0},
                                           {"plastic", kNone, 0.45, 0, 1.5, 0, 0, 0},
                                           {"glass", {1, 1, 1}, 0, 0, 1.5, 1, 0, 0},
                                           {"water", {1, 1, 1}, 0, 0, 1.333, 1, 0, 0},
                                           {"diamond", {1, 1, 1}, 0, 0, 2.417, 1, 55, 0},
                                           {"mirror", {0.95, 0.95, 0.95}, 0, 1, 1.5, 0, 0, 0},
                                           {"gold", {1.022, 0.782, 0.344}, 0.2, 1, 1.5, 0, 0, 0},
                                           {"silver", {0.972, 0.960, 0.915}, 0.15, 1, 1.5, 0, 0, 0},
                                           {"copper", {0.955, 0.638, 0.538}, 0.22, 1, 1.5, 0, 0, 0},
                                           {"steel", {0.562, 0.565, 0.578}, 0.2, 1, 1.5, 0, 0, 0},
                                           {"brushed", {0.562, 0.565, 0.578}, 0.5, 1, 1.5, 0, 0, 0},
                                           {"emissive", {1, 1, 1}, 1, 0, 1, 0, 0, 1}}};

const Preset* preset_named(std::string_view name) {
    const auto found = std::find_if(kPresets.begin(), kPresets.end(), [&](const Preset& p) { return p.name == name; });
    return found == kPresets.end() ? nullptr : &*found;
}

// A number within [lo, hi]; what is no number is lo.
double within(double x, double lo, double hi) { return x > lo ? std::min(x, hi) : lo; }
Vec3 not_negative(Vec3 v, double hi) { return {within(v.x, 0, hi), within(v.y, 0, hi), within(v.z, 0, hi)}; }

// Emission and absorption beyond this say "infinite": sums of them stay finite.
constexpr double kLargest = 1e12;

void set_color(const Material& m, const Preset& preset, Surface& s) {
    s.color = preset.color == kNone ? srgb_to_linear(kUnnamedColor) : preset.color;
    if (m.color) {
        const Vec4 c = *m.color;
        s.color = srgb_to_linear(not_negative(Vec3(c.x, c.y, c.z), 1));
        s.coverage = within(c.w, 0, 1);
    }
    s.color = glm::min(s.color, Vec3(1));
    s.emission = s.color * preset.emission;
    if (m.emission) s.emission = not_negative(*m.emission, kLargest);
}

}  // namespace

const std::vector<std::string_view>& preset_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const Preset& p : kPresets) all.push_back(p.name);
        return all;
    }();
    return names;
}

Result<Surface> resolve_surface(const Material& m) {
    const Preset* preset = preset_named(m.preset.value_or("plastic"));
    if (!preset) return fail(Fault::kScene, fmt::format("Unknown material \"{}\"; known are: {}", *m.preset, fmt::join(preset_names(), ", ")));
    Surface s;
    set_color(m, *preset, s);
    const double roughness = within(m.roughness.value_or(preset->roughness), 0, 1);
    s.alpha = roughness * roughness;
    s.metal = within(m.metal.value_or(preset->metal), 0, 1);
    s.ior = within(m.ior.value_or(preset->ior), 1, 4);
    s.transmission = within(m.transmission.value_or(preset->transmission), 0, 1) * (1 - s.metal);
    s.absorption = not_negative(m.absorption.value_or(Vec3(0)), kLargest);
    s.abbe = within(m.dispersion.value_or(preset->abbe), 0, kLargest);
    s.priority = m.priority.value_or(0);
    const double ratio = (s.ior - 1) / (s.ior + 1);
    s.dielectric_f0 = ratio * ratio;
    return s;
}

Result<std::vector<Surface>> resolve_surfaces(const std::vector<LeafUse>& uses) {
    std::vector<Surface> all;
    all.reserve(uses.size());
    const LeafUse* before = nullptr;
    for (const LeafUse& use : uses) {
        if (before && before->material == use.material) {
            all.push_back(all.back());
            continue;
        }
        const Result<Surface> surface = resolve_surface(use.material);
        if (!surface) return tl::unexpected<Error>(surface.error());
        all.push_back(*surface);
        before = &use;
    }
    return all;
}

}  // namespace whittle
