#include "tracer/light/clear.h"

#include "tracer/light/microsurface.h"
#include "tracer/light/scattering.h"

namespace whittle {

namespace {

double index_of(const Surface* matter, double nm) { return matter ? index_at(*matter, nm) : 1.0; }

std::array<double, 4> etas_of(const Border& border, const Hues& hues) {
    std::array<double, 4> etas;
    for (std::size_t i = 0; i < etas.size(); ++i) etas[i] = eta_at(border, hues.wavelengths()[i]);
    return etas;
}

std::optional<Crossing> cross_sharp(const Stage& stage, const Border& border, Vec3 in, double choice, const std::array<double, 4>& etas, Hues& hues) {
    const double cosine = -glm::dot(in, border.normal), mirror = fresnel_dielectric(cosine, etas[0]);
    const bool hued = disperses(border);
    Crossing c;
    if (choice < mirror) {
        c.direction = mirrored(in, border.normal);
        if (hued) hues.go_on(*stage.spectrum, {mirror, fresnel_dielectric(cosine, etas[1]), fresnel_dielectric(cosine, etas[2]), fresnel_dielectric(cosine, etas[3])});
        return c;
    }
    const std::optional<Vec3> bent = refracted(in, border.normal, etas[0]);
    if (!bent) return std::nullopt;
    c.direction = *bent;
    c.through = true;
    if (hued) hues.hero_alone(*stage.spectrum);
    return c;
}

std::optional<Crossing> cross_rough(const Stage& stage, const Border& border, Vec3 in, const CrossingDraws& draws, const std::array<double, 4>& etas, Hues& hues) {
    const MicroWalk walk = walk_microsurface(in, border.normal, etas, border.surface->alpha, draws.lobe, Stream({draws.choice, draws.lobe.x}));
    if (!walk.left || (glm::dot(walk.direction, border.normal) < 0) != walk.through) return std::nullopt;
    if (disperses(border)) {
        if (walk.bent) hues.hero_alone(*stage.spectrum);
        else hues.go_on(*stage.spectrum, walk.mirrored);
    }
    Crossing c;
    c.direction = walk.direction;
    c.through = walk.through;
    return c;
}

}  // namespace

double eta_at(const Border& border, double nm) { return index_of(border.before, nm) / index_of(border.after, nm); }

bool disperses(const Border& border) { return (border.before && border.before->abbe > 0) || (border.after && border.after->abbe > 0); }

std::optional<Crossing> cross_border(const Stage& stage, const Border& border, Vec3 in, const CrossingDraws& draws, Hues& hues) {
    if (stage.spectrum && disperses(border) && hues.white()) hues.begin(*stage.spectrum, draws.wavelength);
    const std::array<double, 4> etas = etas_of(border, hues);
    std::optional<Crossing> c =
        border.surface->sharp() ? cross_sharp(stage, border, in, draws.choice, etas, hues) : cross_rough(stage, border, in, draws, etas, hues);
    if (c && c->through) c->radiance_scale = etas[0] * etas[0];
    return c;
}

}  // namespace whittle
