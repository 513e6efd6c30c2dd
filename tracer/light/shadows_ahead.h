// shadows_ahead.h — the first shadow rays of a tile's pixels, asked together as packets before the pixels are shaded.
//
// Who shades asks as ever and is given the sample of the lamp that was drawn, and the answer where the very same ray was asked: a ray foreseen in vain costs
// time, never a bit.
#pragma once

#include <array>
#include <vector>

#include "tracer/light/camera_samples.h"
#include "tracer/light/direct.h"

namespace whittle {

class ShadowsAhead {
public:
    ShadowsAhead(const Stage& stage, Scratch& scratch, RenderCounters& counters);

    // Asks for the rays from the first borders of `count` <= MetTogether::kMost samples to the lamps.
    void ask(const FirstBorder* firsts, const CameraSample* samples, int count);
    // The answers of sample `k`; they hold until the next ask().
    AnswersAhead of(int k) const;

private:
    void ask_parts(const FirstBorder* firsts, std::size_t asked);
    void ask_lamp(std::size_t lamp, int part, int parts, const FirstBorder* firsts, const CameraSample* samples, int count);

    const Stage& stage_;
    Scratch& scratch_;
    DirectLight direct_;
    std::size_t slots_ = 0;  // rays a sample; 0: none are asked ahead
    std::vector<ShadowAnswer> answers_;
    std::array<std::size_t, MetTogether::kMost> counts_{};
    std::array<std::size_t, MetTogether::kMost> met_;  // samples
    std::array<Vec3, MetTogether::kMost> points_;      // of those met
    std::array<Sampler, MetTogether::kMost> samplers_;
    std::array<LightSample, MetTogether::kMost> lights_;
    std::array<Ray, MetTogether::kMost> rays_;
    std::array<double, MetTogether::kMost> distances_;
    std::array<Ray, MetTogether::kMost> of_part_;
    std::array<std::size_t, MetTogether::kMost> owners_;  // by ray: its answer
    std::array<bool, MetTogether::kMost> blocked_, by_part_;
};

}  // namespace whittle
