// surface.h — matter resolved: presets filled in, colours linear, scattering's constants found once.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "csg/base/result.h"
#include "csg/base/vec.h"
#include "csg/eval/matter.h"
#include "tracer/engine/engine.h"
#include "tracer/light/gloss_energy.h"

namespace whittle {

// Colour of what names none: OpenSCAD's faces (#f9d72c).
inline constexpr Vec3 kUnnamedColor{249 / 255.0, 215 / 255.0, 44 / 255.0};

// Below this GGX alpha a lobe is an ideal mirror: its half width is under a tenth of a degree.
inline constexpr double kSharpAlpha = 1e-3;

// Everything linear Rec.709. `alpha` is GGX's (roughness squared).
struct Surface {
    Vec3 color{1};
    double coverage = 1;  // 1: opaque; less: the rest goes straight through
    double alpha = 0.25;
    double metal = 0;
    double ior = 1.5;
    double transmission = 0;
    Vec3 absorption{0};  // per mm
    Vec3 emission{0};
    double abbe = 0;  // 0: no dispersion
    double priority = 0;
    double dielectric_f0 = 0.04;  // reflectance of the bare dielectric at normal incidence
    bool conductor = false;       // metal by complex index n + ik, a channel each; else Schlick's curve from `color`
    Vec3 n{1}, k{0};
    Vec3 metal_mean{1};           // reflectance of the metal, mean over the hemisphere
    std::shared_ptr<const GlossEnergy> energy;  // of the opaque lobes; null: only one bounce is counted

    bool clear() const { return transmission > 0; }
    bool see_through() const { return transmission > 0 || coverage < 1; }
    bool sharp() const { return alpha < kSharpAlpha; }
    // Does it need a reflected ray to look like what it is? Plastics do with a highlight and a sheen of the sky.
    bool mirrors() const { return metal > 0 || transmission > 0 || sharp(); }
    // Does it send some light on in single directions, so that lamps behind it can't be sampled?
    bool passes_on() const { return transmission > 0 || (sharp() && (metal > 0 || dielectric_f0 > 0)); }
    // Does it send most of it on so? A varnish does not.
    bool focuses() const { return transmission > 0 || (sharp() && metal > 0); }
    // Is there a lobe with a width, on which focused light can be seen?
    bool receives() const { return coverage > 0 && transmission < 1 && !(sharp() && metal >= 1); }
    bool emits() const { return emission.x > 0 || emission.y > 0 || emission.z > 0; }
};

// The presets' names, in the order of docs/language.
const std::vector<std::string_view>& preset_names();

// Reflectance of the metal at a cosine.
Vec3 metal_reflectance(const Surface& surface, double cosine);

// Parameters named by the author over the preset's. kScene: an unknown preset (the message lists them).
Result<Surface> resolve_surface(const Material& material);

// One a leaf use: the face is coloured by its own use; what remains inside (transmission and so on) by the use of the interior.
Result<std::vector<Surface>> resolve_surfaces(const std::vector<LeafUse>& uses);

}  // namespace whittle
