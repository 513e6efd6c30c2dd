// lanes.cpp — see lanes.h.
#include "tracer/light/lanes.h"

#include "tracer/light/circle.h"
#include "tracer/light/scattering.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/light/lanes_targets.inc"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>  // NOLINT: includes lanes_targets.inc for every target but the last
#include <hwy/highway.h>

#include "tracer/light/lanes_targets.inc"

namespace whittle::lanes {

HWY_EXPORT(keys);
HWY_EXPORT(pairs);
HWY_EXPORT(places);
HWY_EXPORT(window);
HWY_EXPORT(cap);
HWY_EXPORT(disc);
HWY_EXPORT(rectangle);

void keys_of(std::uint64_t seed, const std::uint32_t* x, const std::uint32_t* y, std::size_t count, std::uint32_t* out) {
    HWY_DYNAMIC_DISPATCH(keys)(Sampler::folded(seed), x, y, count, out);
}

void pairs_of(const std::uint32_t* keys, const std::uint32_t* indices, std::size_t count, const PairOf& draw, std::uint32_t* u, std::uint32_t* v, Sequence sequence) {
    if (sequence.kind != SamplerKind::kSobol) {
        for (std::size_t k = 0; k < count; ++k) {
            const std::array<std::uint32_t, 2> pair = Sampler(keys[k], indices[k], sequence).unlike_sobol(draw);
            u[k] = pair[0], v[k] = pair[1];
        }
        return;
    }
    HWY_DYNAMIC_DISPATCH(pairs)(keys, indices, count, draw.which(), draw.parts, draw.part, u, v);
}

void places_of(const FilterSampler::Table& table, const std::uint32_t* u, std::size_t count, double* offsets, double* weights) {
    HWY_DYNAMIC_DISPATCH(places)(table, u, count, offsets, weights);
}

void through_window(const Window& w, const double* x, const double* y, std::size_t count, const Directions& out) {
    HWY_DYNAMIC_DISPATCH(window)(w, x, y, count, out);
}

void in_cap(Vec3 axis, double one_minus_cos, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, const Directions& out) {
    HWY_DYNAMIC_DISPATCH(cap)(ShadingFrame(axis), one_minus_cos, u, v, count, out);
}

void through_disc(const DiscLens& lens, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, const Directions& from, const Directions& rays) {
    HWY_DYNAMIC_DISPATCH(disc)(lens, u, v, count, from, rays);
}

void on_rectangle(const RectangleSides& sides, const Directions& places, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, double* solid_angles) {
    HWY_DYNAMIC_DISPATCH(rectangle)(sides, places, u, v, count, solid_angles);
}

}  // namespace whittle::lanes
