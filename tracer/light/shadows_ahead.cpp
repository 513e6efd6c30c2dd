#include "tracer/light/shadows_ahead.h"

#include <algorithm>

namespace whittle {

namespace {

// More rays a sample than this are asked as they come.
constexpr std::size_t kMostSlots = 16;

// The preview has none, cones have their own.
bool asks_shadows(const Stage& stage) {
    return stage.integrator >= Integrator::kWhitted && stage.integrator <= Integrator::kCaustics && stage.packets && stage.needs.shadows;
}

// Among clear matter, and where several parts are asked, only an open way is known for sure: what is met may let light through, or be hidden by other matter.
bool knows_only_open(const Stage& stage) { return stage.needs.see_through || stage.world.divided(); }

// By so much farther than the lamp is asked there, so that what ends right at it is met.
constexpr double kBeyond = 1 + 1e-9;

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
        ray.departure = border.leaving.event(0);
        distances_[asked] = light.distance;
        owners_[asked++] = answer;
    }
    if (knows_only_open(stage_)) ask_parts(firsts, asked);
    else any_hits(stage_.world.whole(), rays_.data(), distances_.data(), static_cast<int>(asked), scratch_, blocked_.data());
    for (std::size_t i = 0; i < asked; ++i) {
        answers_[owners_[i]].blocked = blocked_[i];
        if (knows_only_open(stage_)) answers_[owners_[i]].asked = !blocked_[i];
    }
}

void ShadowsAhead::ask_parts(const FirstBorder* firsts, std::size_t asked) {
    std::fill_n(blocked_.begin(), asked, false);
    for (std::size_t i = 0; i < asked; ++i) distances_[i] *= kBeyond;
    for (std::size_t part = 0; part < stage_.world.part_count(); ++part) {
        for (std::size_t i = 0; i < asked; ++i) {
            of_part_[i] = rays_[i];
            of_part_[i].departure = firsts[owners_[i] / slots_].border.leaving.event(part);
        }
        any_hits(stage_.world.program(part), of_part_.data(), distances_.data(), static_cast<int>(asked), scratch_, by_part_.data());
        for (std::size_t i = 0; i < asked; ++i) blocked_[i] = blocked_[i] || by_part_[i];
    }
}

AnswersAhead ShadowsAhead::of(int k) const {
    const auto at = static_cast<std::size_t>(k);
    return {answers_.data() + at * slots_, counts_[at]};
}

}  // namespace whittle
