// tracer.h — the light along one ray: Whitted's tree of mirrors and refractions, with areas sampled where the integrator distributes.
//
// With cones instead of rays (cone.h) edges that cross a pixel, a lamp's disc or a blurred image divide it: one ray for each part.
//
// With light passes (light_pass.h) the tree's leaves see caustics too: photons are gathered wherever lamps are asked, and clear matter throws full shadows.
//
// One object a thread; of memory it owns only what cones are divided in. Continuation rays carry the events they leave, so there is no epsilon anywhere.
// Sources: Whitted, An Improved Illumination Model (1980); Cook, Porter, Carpenter, Distributed Ray Tracing (1984); Amanatides, Ray Tracing with Cones (1984);
// Jensen, Global Illumination using Photon Maps (1996).
#pragma once

#include <memory>

#include "tracer/engine/cone.h"
#include "tracer/light/bsdf.h"
#include "tracer/light/clear.h"
#include "tracer/light/direct.h"
#include "tracer/light/light_pass.h"
#include "tracer/light/sampler.h"
#include "tracer/light/stage.h"

namespace whittle {

class Tracer {
public:
    Tracer(const Stage& stage, Scratch& scratch, RenderCounters& counters)
        : stage_(stage), direct_(stage, scratch, counters), scratch_(scratch), counters_(counters), cones_(cones() ? new ConeSplitter : nullptr) {}

    // Light that arrives against the camera ray. `height` is its place in the picture, -1..1 from bottom to top; `first` what the ray meets, where known.
    CameraLight camera_light(const Ray& ray, double height, const Sampler& sampler, const FirstBorder* first = nullptr);

    // Shadows of the next camera ray that are known.
    void know(AnswersAhead ahead) { direct_.know(ahead); }

private:
    // One ray of the tree. `weight`: the largest share of the pixel it can make.
    struct Branch {
        int depth = 0;     // mirrors and refractions so far
        int straight = 0;  // thin covers passed
        double weight = 1;
        double spread = 0;  // GGX alpha that rough mirrors on the way have blurred everything by
        bool sees_lights = true;
        bool rough = false;    // a rough mirror or rough clear matter is on the way
        bool brought = false;  // and after it a sharp one: where there are photons they bring what lamps send by that way
        double wide = 0, widens = 0;  // cone tracing: radius where the ray starts (where shaded: ends), and by how much it grows a mm
        Vec3 out{0};  // cone tracing: normal of the surface left, on the side that the ray goes to
        Hues hues;
    };

    Vec3 follow(const Ray& ray, const Leaving* leaving, const Branch& branch);
    ConeParts divided(const Cone& cone, const FirstBorder& first) const;
    CameraLight light_from(const Ray& ray, double height, const FirstBorder& known);
    CameraLight cone_light(const Ray& ray, double height, const FirstBorder& first);
    Vec3 follow_cone(const Ray& ray, const Leaving* leaving, const Branch& branch, const FirstBorder& axis);
    Vec3 seen(const Ray& ray, const FirstBorder& first, const Branch& branch);
    void take_pass(int sample);
    bool brought(const Branch& branch) const { return pass_ && branch.brought; }
    // How shadow rays meet clear matter: where there are photons they bring the light behind it.
    ClearShadows clear_shadows() const { return pass_ ? ClearShadows::kBlock : ClearShadows::kLetThrough; }
    static Footprint footprint(const Border& border, Vec3 view, double radius);
    Vec3 shade(const Ray& ray, const Border& border, const Branch& branch);
    Vec3 shade_as(const Surface& surface, const Ray& ray, const Border& border, const Branch& branch);
    Vec3 lit(const Surface& surface, const Border& border, const Bsdf& bsdf, const Branch& branch);
    Vec3 sky(const Surface& surface, const Border& border, const Bsdf& bsdf, const Branch& branch);
    Vec3 reflection(const Surface& surface, const Ray& ray, const Border& border, const Bsdf& bsdf, const Branch& branch);
    Vec3 through_clear(const Surface& surface, const Ray& ray, const Border& border, const Branch& branch);
    Vec3 through_rough(const Ray& ray, const Border& border, const Branch& onward);
    Vec3 straight_on(const Ray& ray, const Border& border, const Branch& branch);
    Vec2 lobe(const Branch& branch) const { return sampler_->pair(Draw::kLobe, static_cast<std::uint32_t>(branch.depth)); }
    bool distributes() const { return stage_.distributes(); }
    bool cones() const { return stage_.integrator == Integrator::kCone; }

    const Stage& stage_;
    DirectLight direct_;
    Scratch& scratch_;
    RenderCounters& counters_;
    std::unique_ptr<ConeSplitter> cones_;  // null: rays have no width
    const Sampler* sampler_ = nullptr;
    std::shared_ptr<const LightPass> pass_;  // of the sample; null: there are no photons
    int pass_number_ = -1;
    double time_ = 0;  // of the sample
};

}  // namespace whittle
