#include "tracer/light/shadows_ahead.h"

namespace whittle {

namespace {

// More rays a sample than this are asked as they come.
constexpr std::size_t kMostSlots = 16;

// Among clear matter shadow rays are followed, not asked; the preview has none, cones have their own.
bool asks_shadows(const Stage& stage) {
    const bool integrates = stage.integrator == Integrator::kWhitted || stage.integrator == Integrator::kDistributed || stage.integrator == Integrator::kPath;
    return integrates && stage.packets && stage.needs.shadows && !stage.needs.see_through && !stage.world.divided();
}

}  // namespace

ShadowsAhead::ShadowsAhead(const Stage& stage, Scratch& scratch, RenderCounters& counters) : stage_(stage), scratch_(scratch), direct_(stage, scratch, counters) {
    if (!asks_shadows(stage)) return;
    for (const LightSource& lamp : stage.lights)
        if (lamp.casts_shadow) slots_ += static_cast<std::size_t>(direct_.parts_of(lamp));
    if (slots_ > kMostSlots) slots_ = 0;
    answers_.resize(slots_ * MetTogether::kMost);
}

void ShadowsAhead::ask(const FirstBorder* firsts, const CameraSample* samples, int count) {
    counts_.fill(0);
    if (slots_ == 0) return;
    for (std::size_t lamp = 0; lamp < stage_.lights.size(); ++lamp) {
        if (!stage_.lights[lamp].casts_shadow) continue;
        const int parts = direct_.parts_of(stage_.lights[lamp]);
        for (int part = 0; part < parts; ++part) ask_lamp(lamp, part, parts, firsts, samples, count);
    }
}

void ShadowsAhead::ask_lamp(std::size_t lamp, int part, int parts, const FirstBorder* firsts, const CameraSample* samples, int count) {
    std::size_t met = 0, asked = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        if (!firsts[k].met) continue;
        met_[met] = k;
        points_[met] = firsts[k].border.point;
        samplers_[met++] = samples[k].sampler;
    }
    direct_.sample_many(lamp, points_.data(), samplers_.data(), met, part, parts, lights_.data());
    for (std::size_t i = 0; i < met; ++i) {
        const std::size_t k = met_[i];
        const Border& border = firsts[k].border;
        const LightSample& light = lights_[i];
        const bool dark = !(glm::dot(border.normal, light.direction) > 0) || (light.radiance == Vec3(0) && !stage_.needs.dark_lamps);
        const std::size_t answer = k * slots_ + counts_[k]++;
        answers_[answer] = {border.point, samples[k].ray.time, light, static_cast<std::uint32_t>(lamp), static_cast<std::uint32_t>(part), !dark, false};
        if (dark) continue;
        Ray& ray = rays_[asked];
        ray.origin = border.point;
        ray.direction = light.direction;
        ray.time = samples[k].ray.time;
        ray.departure = border.leaving.parts ? &border.leaving.events[0] : nullptr;
        distances_[asked] = light.distance;
        owners_[asked++] = answer;
    }
    any_hits(stage_.world.whole(), rays_.data(), distances_.data(), static_cast<int>(asked), scratch_, blocked_.data());
    for (std::size_t i = 0; i < asked; ++i) answers_[owners_[i]].blocked = blocked_[i];
}

AnswersAhead ShadowsAhead::of(int k) const {
    const auto at = static_cast<std::size_t>(k);
    return {answers_.data() + at * slots_, counts_[at]};
}

}  // namespace whittle
