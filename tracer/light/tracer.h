// tracer.h — the light along one ray: Whitted's tree of mirrors and refractions, with areas sampled where the integrator distributes.
//
// One object a tile; it owns nothing. Continuation rays carry the event they leave, so there is no epsilon anywhere.
// Sources: Whitted, An Improved Illumination Model (1980); Cook, Porter, Carpenter, Distributed Ray Tracing (1984).
#pragma once

#include "tracer/light/sampler.h"
#include "tracer/light/stage.h"

namespace whittle {

class Tracer {
public:
    Tracer(const Stage& stage, Scratch& scratch, RenderCounters& counters) : stage_(stage), scratch_(scratch), counters_(counters) {}

    struct Light {
        Vec3 radiance{0};
        double coverage = 0;  // 1 where the camera ray met the solid
    };
    // Light that arrives against the camera ray. `height` is its place in the picture, -1..1 from bottom to top.
    Light camera_light(const Ray& ray, double height, const Sampler& sampler);

private:
    // One ray of the tree. `weight`: the largest share of the pixel it can make.
    struct Branch {
        int depth = 0;  // mirrors and refractions so far
        int straight = 0;  // thin covers passed
        double weight = 1;
        bool sees_lights = true;
    };
    struct Meeting {
        Hit hit;
        const Surface* surface;
        Vec3 normal;  // towards the viewer
        Vec3 view;    // unit, towards the viewer
        double cos_view;
    };

    Vec3 follow(const Ray& ray, const Branch& branch);
    Vec3 beyond(const Ray& ray, const Branch& branch) const;
    Vec3 shade(const Ray& ray, Hit& hit, const Branch& branch);
    Vec3 lit(const Meeting& m, const Branch& branch);
    Vec3 lit_by(const LightSource& light, std::size_t number, const Meeting& m, const Branch& branch);
    Vec3 sky(const Meeting& m, const Branch& branch);
    Vec3 reflection(const Ray& ray, const Meeting& m, const Branch& branch);
    Vec3 through_glass(const Ray& ray, const Meeting& m, const Branch& branch);
    Vec3 continued(const Ray& ray, const Meeting& m, const Branch& branch);
    Vec3 scattering(const Meeting& m, Vec3 direction, double cos_light) const;
    Vec3 transmittance(const Meeting& m, Vec3 direction, double distance);
    bool distributes() const { return stage_.integrator >= Integrator::kDistributed; }

    const Stage& stage_;
    Scratch& scratch_;
    RenderCounters& counters_;
    const Sampler* sampler_ = nullptr;
};

}  // namespace whittle
