// surface.h — matter resolved: presets filled in, colours linear, scattering's constants found once.
#pragma once

#include <string_view>
#include <vector>

#include "csg/base/result.h"
#include "csg/base/vec.h"
#include "csg/eval/matter.h"
#include "tracer/engine/engine.h"

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

    bool clear() const { return transmission > 0; }
    bool see_through() const { return transmission > 0 || coverage < 1; }
    bool sharp() const { return alpha < kSharpAlpha; }
    // Does it need a reflected ray to look like what it is? Plastics do with a highlight and a sheen of the sky.
    bool mirrors() const { return metal > 0 || transmission > 0 || sharp(); }
    bool emits() const { return emission.x > 0 || emission.y > 0 || emission.z > 0; }
};

// The presets' names, in the order of docs/language.
const std::vector<std::string_view>& preset_names();

// Parameters named by the author over the preset's. kScene: an unknown preset (the message lists them).
Result<Surface> resolve_surface(const Material& material);

// One a leaf use: the face is coloured by its own use; what remains inside (transmission and so on) by the use of the interior.
Result<std::vector<Surface>> resolve_surfaces(const std::vector<LeafUse>& uses);

}  // namespace whittle
