#include "tracer/light/bsdf.h"

#include "tracer/image/tone.h"

namespace whittle {

namespace {

// A viewer in the face itself sees it under this cosine: keeps quotients finite without being seen.
constexpr double kLeastCosine = 1e-9;

}  // namespace

Bsdf::Bsdf(const Surface& s, Vec3 normal, Vec3 view)
    : surface_(s), normal_(normal), view_(view), cos_view_(std::max(kLeastCosine, glm::dot(normal, view))) {
    under_coat_ = s.color * ((1 - s.metal) * (1 - (s.energy ? s.energy->coat(cos_view_) : coat(cos_view_))));
    gloss_ = !s.sharp() && (s.dielectric_f0 > 0 || s.metal > 0);
    if (!gloss_) return;
    if (s.metal > 0 && s.energy) {
        const double mean = s.energy->mirror_mean();
        const Vec3 tint = s.metal_mean * s.metal_mean * mean / (Vec3(1) - s.metal_mean * (1 - mean));
        among_facets_ = tint * (s.metal * (1 - s.energy->mirror(cos_view_)));
    }
    const double gloss = luminance(mirror_share(cos_view_)), dull = luminance(dull_albedo());
    gloss_share_ = gloss + dull > 0 ? std::clamp(gloss / (gloss + dull), dull > 0 ? 0.1 : 1.0, 1.0) : 1;
}

Vec3 Bsdf::mirror_share(double cosine) const {
    if (!(surface_.metal > 0)) return Vec3(coat(cosine));
    return glm::mix(Vec3(coat(cosine)), metal_reflectance(surface_, cosine), surface_.metal);
}

Vec3 Bsdf::dull_value(double cos_light) const {
    if (!surface_.energy) return under_coat_ / kPi;
    const GlossEnergy& e = *surface_.energy;
    Vec3 sum = under_coat_ * ((1 - e.coat(cos_light)) / (1 - e.coat_mean()));
    if (surface_.metal > 0 && e.mirror_mean() < 1) sum += among_facets_ * ((1 - e.mirror(cos_light)) / (1 - e.mirror_mean()));
    return sum / kPi;
}

Vec3 Bsdf::value(Vec3 direction, double cos_light) const {
    const Vec3 dull = dull_value(cos_light);
    if (!gloss_) return dull;
    const Vec3 half = glm::normalize(direction + view_);
    const double density = ggx_density(glm::dot(normal_, half), surface_.alpha);
    return dull + mirror_share(glm::dot(view_, half)) * (density * ggx_visibility(cos_light, cos_view_, surface_.alpha));
}

Vec3 Bsdf::micro_normal(Vec2 u) const {
    if (surface_.sharp()) return normal_;
    const ShadingFrame frame(normal_);
    return frame.to_world(ggx_visible_normal(frame.to_local(view_), surface_.alpha, u));
}

double Bsdf::density(Vec3 direction, double cos_light) const {
    const double dull = cos_light / kPi;
    if (!gloss_) return dull;
    const Vec3 half = glm::normalize(direction + view_);
    const double glossy = ggx_density(glm::dot(normal_, half), surface_.alpha) * ggx_masking(cos_view_, surface_.alpha) / (4 * cos_view_);
    return glm::mix(dull, glossy, gloss_share_);
}

Bsdf::Drawn Bsdf::draw(Vec2 u, double choice) const {
    Drawn d;
    d.direction = gloss_ && choice < gloss_share_ ? mirrored(-view_, micro_normal(u)) : ShadingFrame(normal_).to_world(on_cosine_hemisphere(u));
    const double cos_light = glm::dot(d.direction, normal_);
    if (!(cos_light > 0)) return d;
    d.density = density(d.direction, cos_light);
    if (!(d.density > 0)) return Drawn{d.direction, Vec3(0), 0};
    d.share = value(d.direction, cos_light) * (cos_light / d.density);
    return d;
}

}  // namespace whittle
