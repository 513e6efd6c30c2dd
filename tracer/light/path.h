// path.h — path tracing: the rendering equation by random walks from the eye.
//
// At every vertex lamps are sampled and the scattered ray may meet them too; the two are weighed by the power heuristic. Clear matter is
// walked through, never sampled through: light of lamps without a size does not pass it, unless the stage has light passes (light_pass.h), which bring
// what lamps send through mirrors and clear matter onto dull surfaces. Absorption by lengths inside, borders as in world.h.
// Sources: Kajiya (1986); Veach, Robust Monte Carlo Methods (1997), chapters 9 and 10.
#pragma once

#include "tracer/light/clear.h"
#include "tracer/light/direct.h"
#include "tracer/light/light_pass.h"

namespace whittle {

class PathTracer {
public:
    PathTracer(const Stage& stage, Scratch& scratch, RenderCounters& counters) : stage_(stage), direct_(stage, scratch, counters), scratch_(scratch), counters_(counters) {}

    // As Tracer::camera_light().
    CameraLight camera_light(const Ray& ray, double height, const Sampler& sampler, const FirstBorder* first = nullptr);
    // Of the latest sample; null: none.
    const LightPass* pass() const { return pass_.get(); }

    // Shadows of the next camera ray that are known.
    void know(AnswersAhead ahead) { direct_.know(ahead); }

private:
    // The walk so far.
    struct Walk {
        Ray ray;
        Leaving leaving;
        bool departs = false;
        bool single = true;    // the last scattering had one direction only (or there was none): lamps met count fully
        bool straight = true;  // nothing but thin covers since the eye
        bool dull = false;     // was scattered by a dull or glossy surface
        double density = 0;    // of the last scattering's direction
        Vec3 share{1};         // without the colour of its wavelengths
        Hues hues;
        Vec3 radiance{0};
        int bounce = 0;
        int covers = 0;
        Vec3 carried() const { return share * hues.color(); }
    };

    void take_pass(int number);
    bool step(Walk& walk, double height, const Sampler& sampler, const FirstBorder* known);
    void meet_lamp(Walk& walk, const LightMet& lamp) const;
    void add_lamps(Walk& walk, const Border& border, const Bsdf& bsdf, const Sampler& sampler);
    bool scatter(Walk& walk, const Border& border, const Bsdf& bsdf, const Sampler& sampler);
    void add_photons(Walk& walk, const Border& border, const Bsdf& bsdf) const;
    bool scatter_clear(Walk& walk, const Border& border, Vec2 u, double choice, const Sampler& sampler);
    Vec3 surroundings(const Walk& walk, double height) const;

    const Stage& stage_;
    DirectLight direct_;
    Scratch& scratch_;
    RenderCounters& counters_;
    std::shared_ptr<const LightPass> pass_;  // of the sample; null: the scene needs none
    int pass_number_ = -1;
};

}  // namespace whittle
