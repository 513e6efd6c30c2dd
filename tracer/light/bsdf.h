// bsdf.h — scattering at one border for one viewing direction: its value, its lobes, and directions drawn from them.
//
// The opaque share of a surface has two lobes: a GGX one, and a dull one, which is what the matter under a dielectric coat sends back, or in a metal the
// light of several bounces among the microfacets (gloss_energy.h). value() is reciprocal. Mirrors and clear borders scatter into directions that are
// followed by their own rays; they have no value here.
#pragma once

#include "tracer/light/scattering.h"
#include "tracer/light/surface.h"

namespace whittle {

class Bsdf {
public:
    // `normal` and `view` (towards the viewer) are unit vectors with normal.view >= 0.
    Bsdf(const Surface& surface, Vec3 normal, Vec3 view);

    // Share of light from `direction` (away from the surface, cosine `cos_light` > 0) that goes to the viewer, per unit of solid angle and cosine.
    Vec3 value(Vec3 direction, double cos_light) const;
    // The dull lobe's part of value().
    Vec3 dull_value(double cos_light) const;
    // Albedo of the dull lobe: what white light from everywhere makes of it.
    Vec3 dull_albedo() const { return under_coat_ + among_facets_; }
    // Reflectance of a mirror with this surface's colour, at the cosine to its normal.
    Vec3 mirror_share(double cosine) const;
    // Weight of the surroundings' dull image in a rough dielectric coat: what its reflectance leaves when the roughness has spread it.
    double sheen() const { return gloss_ ? (1 - surface_.metal) * (1 - surface_.alpha) * coat(cos_view_) : 0; }
    Vec3 view() const { return view_; }
    // Is there a lobe with a width that lights themselves shine into?
    bool gloss() const { return gloss_; }
    // Share of draws that the GGX lobe gets.
    double gloss_chance() const { return gloss_share_; }

    // A microfacet's normal for a mirror or refraction; the normal itself where the surface is sharp.
    Vec3 micro_normal(Vec2 u) const;

    // One direction of both lobes together. `choice` in [0,1) picks the lobe.
    struct Drawn {
        Vec3 direction{0};
        Vec3 share{0};       // value x cosine / density
        double density = 0;  // over solid angle; 0: none was found
    };
    Drawn draw(Vec2 u, double choice) const;
    double density(Vec3 direction, double cos_light) const;

private:
    // Reflectance of the bare dielectric; exactly none where its index is 1.
    double coat(double cosine) const { return surface_.dielectric_f0 > 0 ? fresnel_dielectric(std::clamp(cosine, 0.0, 1.0), 1 / surface_.ior) : 0; }

    const Surface& surface_;
    Vec3 normal_, view_;
    double cos_view_;
    Vec3 under_coat_, among_facets_{0};  // albedos of the dull lobe's two parts
    bool gloss_;
    double gloss_share_ = 0;  // of draws
};

}  // namespace whittle
