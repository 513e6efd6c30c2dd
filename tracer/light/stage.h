// stage.h — everything a tile needs, resolved once: matter, lights, lens, sampler.
#pragma once

#include <memory>
#include <vector>

#include "tracer/image/filter.h"
#include "tracer/light/emission.h"
#include "tracer/light/lights.h"
#include "tracer/light/render.h"
#include "tracer/light/spectrum.h"
#include "tracer/light/surface.h"
#include "tracer/light/surroundings.h"
#include "tracer/light/world.h"

namespace whittle {

// What the scene holds, so that passes nobody needs are left out.
struct StageNeeds {
    bool shadows = true;      // some light casts them
    bool see_through = false; // glass or coverage: shadow rays are followed, not asked
    bool mirrors = false;
    bool glossy = false;      // rough mirrors or rough glass
    bool soft_lights = false; // with a size
    bool lens = false;        // an aperture
    bool shutter = false;     // something moves
    bool spectrum = false;    // an index depends on the wavelength
    bool photons = false;     // lamps shine through something that focuses onto something dull
    bool dark_lamps = false;  // lamps without light are asked all the same
    bool sizeless = false;    // places are drawn on lamps without a size
};

class LightPasses;

class Stage {
public:
    std::shared_ptr<const Program> program;
    RenderOptions options;
    Integrator integrator = Integrator::kWhitted;
    double noise = 0;  // of a tile that is good enough; 0: none is
    World world;
    std::vector<Surface> surfaces;  // by leaf use of the whole program, for planes
    std::vector<LightSource> lights;
    Surroundings surroundings;
    Lens lens;
    FilterSampler filter{FilterKind::kGaussian};
    StageNeeds needs;
    bool packets = true;  // --disable packets: every ray alone
    std::unique_ptr<const Spectrum> spectrum;          // null: nothing disperses, or the integrator follows no wavelengths
    Emission emission;                                 // of light passes
    std::shared_ptr<const LightPasses> light_passes;   // null: caustics are not asked for, or nothing makes them
    double thickness_scale = 1;  // of --xray, mm
    std::vector<std::string> warnings;
    // Does the integrator draw from areas: lamps, lobes, lens, shutter?
    bool distributes() const { return integrator >= Integrator::kDistributed && integrator != Integrator::kCone; }
    std::string reason;          // why auto chose this integrator, in words that follow its name
    // Is it OpenSCAD's preview in one of its colour schemes?
    bool shows_scheme() const { return options.scheme && integrator == Integrator::kPreview; }
};

}  // namespace whittle
