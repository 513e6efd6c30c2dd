// light_walk.h — one ray of light from a lamp through mirrors and clear matter to the first dull surface.
#pragma once

#include "tracer/light/clear.h"
#include "tracer/light/direct.h"
#include "tracer/light/light_pass.h"

namespace whittle {

// What rays left behind.
struct LightLeft {
    std::vector<Photon> photons;
    std::vector<Splat> splats;
};

// A picture of these options that nothing is drawn on yet.
Splats picture_of(const RenderOptions& options);

// The time within the shutter of light pass `index`: the same for its photons and for all eyes that come by.
double time_of_pass(const Stage& stage, int index);

class LightWalker {
public:
    // Of the `rays` rays of pass `index`. With `on_picture` what they leave is drawn onto the picture too.
    LightWalker(const Stage& stage, int index, int rays, bool on_picture);
    // Rays [begin, end), which meet their first borders together.
    void walk(int begin, int end, LightLeft& left);

private:
    struct Beam {
        Ray ray;
        Leaving leaving;
        Vec3 power{0};
        double first = 0;  // brightness at the lamp
        Hues hues;
        int bounce = 0;
        int covers = 0;
        bool focused = false;  // met a mirror or clear matter
    };
    Sampler sampler_of(int ray) const;
    Beam sent(const Sampler& sampler) const;
    void walk_together(int begin, int end, LightLeft& left);
    bool step(Beam& beam, const Sampler& sampler, LightLeft& left);
    bool go_on(Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left);
    bool scatter(Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left);
    void leave(const Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left);
    void draw(const Beam& beam, const Border& border, const Sampler& sampler, LightLeft& left);

    const Stage& stage_;
    int index_, rays_;
    bool on_picture_;
    Splats picture_;  // empty
    Scratch scratch_;
    RenderCounters counters_;
    DirectLight direct_;
    MetTogether met_;
    std::vector<Beam> beams_;
    std::vector<Sampler> samplers_;
    std::vector<Ray> rays_together_;
};

}  // namespace whittle
