#include "tracer/light/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "tracer/image/tone.h"
#include "tracer/light/scattering.h"

namespace whittle {

namespace {

// Refractive index and extinction at 650, 550 and 450 nm, interpolated from P. Johnson and R. Christy, Optical Constants of the Noble Metals (1972)
// and of Transition Metals (1974; iron stands for steel).
struct Conductor {
    Vec3 n, k;
};
constexpr Conductor kGold{{0.15, 0.43, 1.38}, {3.60, 2.46, 1.91}}, kSilver{{0.05, 0.06, 0.04}, {4.41, 3.60, 2.65}};
constexpr Conductor kCopper{{0.23, 1.01, 1.24}, {3.65, 2.58, 2.39}}, kIron{{2.91, 2.95, 2.58}, {3.09, 2.93, 2.77}};

struct Preset {
    std::string_view name;
    Vec3 color;  // linear
    double roughness, metal, ior, transmission, abbe;
    double emission;
    const Conductor* conductor = nullptr;  // then it has no colour of its own
};

// Indices and Abbe numbers: crown glass BK7 rounded to the customary 1.5, water and diamond at the sodium line.
constexpr Vec3 kNone{-1};  // OpenSCAD's colour
constexpr std::array<Preset, 12> kPresets{{{"matte", kNone, 1, 0, 1, 0, 0, 0},
                                           {"plastic", kNone, 0.45, 0, 1.5, 0, 0, 0},
                                           {"glass", {1, 1, 1}, 0, 0, 1.5, 1, 0, 0},
                                           {"water", {1, 1, 1}, 0, 0, 1.333, 1, 0, 0},
                                           {"diamond", {1, 1, 1}, 0, 0, 2.417, 1, 55, 0},
                                           {"mirror", {0.95, 0.95, 0.95}, 0, 1, 1.5, 0, 0, 0},
                                           {"gold", kNone, 0.2, 1, 1.5, 0, 0, 0, &kGold},
                                           {"silver", kNone, 0.15, 1, 1.5, 0, 0, 0, &kSilver},
                                           {"copper", kNone, 0.22, 1, 1.5, 0, 0, 0, &kCopper},
                                           {"steel", kNone, 0.2, 1, 1.5, 0, 0, 0, &kIron},
                                           {"brushed", kNone, 0.5, 1, 1.5, 0, 0, 0, &kIron},
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

void set_conductor(const Conductor& conductor, Surface& s) {
    s.conductor = true;
    s.n = conductor.n;
    s.k = conductor.k;
    s.color = metal_reflectance(s, 1);
}

// A conductor that the author gives a colour has that one.
void set_color(const Material& m, const Preset& preset, Surface& s) {
    s.color = preset.color == kNone ? srgb_to_linear(kUnnamedColor) : preset.color;
    if (preset.conductor && !m.color) set_conductor(*preset.conductor, s);
    if (m.color) {
        const Vec4 c = *m.color;
        s.color = srgb_to_linear(not_negative(Vec3(c.x, c.y, c.z), 1));
        s.coverage = within(c.w, 0, 1);
    }
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

Vec3 metal_reflectance(const Surface& s, double cosine) {
    if (!s.conductor) return fresnel_schlick(s.color, cosine);
    return {fresnel_conductor(cosine, s.n.x, s.k.x), fresnel_conductor(cosine, s.n.y, s.k.y), fresnel_conductor(cosine, s.n.z, s.k.z)};
}

namespace {

// 2 * integral of the reflectance times the cosine.
Vec3 mean_reflectance(const Surface& s) {
    constexpr int kSteps = 64;
    Vec3 sum(0);
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = (i + 0.5) / kSteps;
        sum += metal_reflectance(s, cosine) * (2 * cosine / kSteps);
    }
    return glm::min(sum, Vec3(1));
}

// Surfaces of one scene: lobes that are alike share their tables.
class Resolver {
public:
    Result<Surface> operator()(const Material& m) {
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
        if (s.metal > 0) s.metal_mean = mean_reflectance(s);
        if (s.transmission < 1 && (s.dielectric_f0 > 0 || s.metal > 0)) s.energy = energy_of(s.sharp() ? 0 : s.alpha, s.ior);
        return s;
    }

private:
    std::shared_ptr<const GlossEnergy> energy_of(double alpha, double ior) {
        std::shared_ptr<const GlossEnergy>& energy = energies_[{alpha, ior}];
        if (!energy) energy = std::make_shared<GlossEnergy>(alpha, ior);
        return energy;
    }
    std::map<std::pair<double, double>, std::shared_ptr<const GlossEnergy>> energies_;
};

}  // namespace

Result<Surface> resolve_surface(const Material& material) { return Resolver()(material); }

Result<std::vector<Surface>> resolve_surfaces(const std::vector<LeafUse>& uses) {
    Resolver resolve;
    std::vector<Surface> all;
    all.reserve(uses.size());
    const LeafUse* before = nullptr;
    for (const LeafUse& use : uses) {
        if (before && before->material == use.material) {
            all.push_back(all.back());
            continue;
        }
        const Result<Surface> surface = resolve(use.material);
        if (!surface) return tl::unexpected<Error>(surface.error());
        all.push_back(*surface);
        before = &use;
    }
    return all;
}

}  // namespace whittle
