// direct.h — light that comes straight from a lamp: shadows, lamps seen, light let through.
#pragma once

#include <memory>

#include "tracer/engine/cone.h"
#include "tracer/light/bsdf.h"
#include "tracer/light/sampler.h"
#include "tracer/light/stage.h"

namespace whittle {

// What a camera ray brings. `coverage`: 1 where it met the solid.
struct CameraLight {
    Vec3 radiance{0};
    double coverage = 0;
    Vec3 drawn{0};  // what rays from the lamps drew on the pixel; it has its filter weight already
};

// Share of light that is left after `length` mm.
Vec3 absorbed(Vec3 per_mm, double length);
// What is lost inside `border.before` on the way to the border.
Vec3 absorbed_before(const Border& border);
inline double largest(Vec3 v) { return std::max(v.x, std::max(v.y, v.z)); }

// How clear matter lets shadow rays pass: unbent (a picture without caustics), or not at all (who follows light through it himself).
enum class ClearShadows { kLetThrough, kBlock };

// A sample of a lamp at a first border, drawn before it is wanted, and whether it is blocked, if that was asked and is known (shadows_ahead.h): among clear matter
// only that nothing at all is in the way.
struct ShadowAnswer {
    Vec3 origin;
    double time;
    LightSample sample;
    std::uint32_t lamp, part;
    bool asked, blocked;
};
struct AnswersAhead {
    const ShadowAnswer* first = nullptr;
    std::size_t count = 0;
};

// Without width, yet. Its points go with the lens, so that pictures of a scene that is turned with its camera are divided alike.
inline Cone cone_about(const Lens& lens, const Ray& axis) {
    Cone cone;
    cone.axis = axis;
    cone.right = lens.right;
    cone.up = lens.up;
    return cone;
}

// The ellipse on a surface that a cone of rays covers: its half axes.
struct Footprint {
    Vec3 u{0}, v{0};
};

class DirectLight {
public:
    DirectLight(const Stage& stage, Scratch& scratch, RenderCounters& counters)
        : stage_(stage), scratch_(scratch), counters_(counters), cones_(stage.integrator == Integrator::kCone ? new ConeSplitter : nullptr) {}

    // Sample `part` of `parts` of lamp `number`, from `point`.
    LightSample sample(std::size_t number, Vec3 point, const Sampler& sampler, int bounce, int part, int parts) const;
    // The numbers that sample() draws for a lamp; none where its middle stands for it.
    std::optional<PairOf> draw_of(std::size_t number, int bounce, int part, int parts) const;
    // Sample `part` of `parts` of lamp `number` at first borders: from `points` by the numbers `samplers` draw. There are at most lanes::kMost.
    void sample_many(std::size_t number, const Vec3* points, const Sampler* samplers, std::size_t count, int part, int parts, LightSample* samples);
    // Samples that lamp deserves at a hit.
    int parts_of(const LightSource& lamp) const;
    // Share of light that comes to the border from `direction`, `distance` away: 0 or 1 among opaque matter.
    Vec3 transmittance(const Border& border, Vec3 direction, double distance, double time, ClearShadows clear) const;
    // The same from all of a lamp, whose middle is `sample`, to all places of a footprint: edges that cross the cone between them hide parts.
    // Requires: the integrator is kCone.
    Vec3 cone_transmittance(const Border& border, const LightSource& lamp, const LightSample& sample, const Footprint& footprint) const;
    // Answers to take where the same is asked, until others are given.
    void know(AnswersAhead ahead) { ahead_ = ahead; }
    // Is a lamp nearer than t_max on the ray?
    bool lamp_seen(const Ray& ray, double t_max, LightMet& met) const;

private:
    // The answer to this very ray; null: it is not known.
    const ShadowAnswer* known(const Ray& ray, double distance) const;

    const Stage& stage_;
    Scratch& scratch_;
    RenderCounters& counters_;
    std::unique_ptr<ConeSplitter> cones_;  // null: rays have no width
    AnswersAhead ahead_;
};

}  // namespace whittle
