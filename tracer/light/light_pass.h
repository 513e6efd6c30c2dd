// light_pass.h — light that mirrors and clear matter throw onto dull surfaces: caustics, followed from the lamps.
//
// Sample i of every pixel has pass i, a fresh set of rays from the lamps. Where such a ray, after one or more mirrors and refractions, reaches a dull
// surface, it is drawn onto the picture if the eye sees that place without a detour (light tracing: no bias), and it is left there as a photon for eyes that
// come by mirrors, glass or dull surfaces. The search radius of the passes shrinks so that their mean converges to the truth.
// Sources: Knaus and Zwicker, Progressive Photon Mapping: A Probabilistic Approach (2011); Veach (1997), chapter 10 (light tracing).
#pragma once

#include <memory>
#include <vector>

#include "tracer/light/photon_map.h"
#include "tracer/light/splats.h"
#include "tracer/light/stage.h"

namespace whittle {

class LightPass {
public:
    LightPass(PhotonMap map, Splats splats, bool on_picture) : map_(std::move(map)), splats_(std::move(splats)), on_picture_(on_picture) {}

    // Does it draw onto the picture? Else photons stand for what the eye sees at once too.
    bool draws_on_picture() const { return on_picture_; }
    // Caustics on a border towards the viewer of `bsdf`.
    Vec3 gathered(const Border& border, const Bsdf& bsdf) const { return map_.radiance(border.point, border.normal, bsdf); }
    // What the rays draw on a pixel; to be added to the sample of this number, already weighed by the filter.
    Vec3 on_pixel(int x, int y) const { return splats_.on_pixel(x, y); }
    const PhotonMap& map() const { return map_; }

private:
    PhotonMap map_;
    Splats splats_;
    bool on_picture_;
};

// What the passes of a stage are.
struct PassPlan {
    enum class Draws { kOntoPicture, kNothing };
    int rays = 1;                  // of a pass
    Draws draws = Draws::kNothing;
    bool once = false;             // one pass stands for all samples
    std::int64_t shrunk_for = 0;   // > 0: the search radius is that of as many rays in all; else it shrinks from pass to pass
};

// The passes of a stage. Made when first asked for, the latest kept; each depends on the seed and its number only.
class LightPasses {
public:
    // Requires: `stage` outlives it; its emission shines.
    LightPasses(const Stage& stage, const PassPlan& plan);
    ~LightPasses();

    // Passes [begin, end) on all cores, as far as they are kept.
    void make(int begin, int end) const;
    std::shared_ptr<const LightPass> pass(int sample) const;
    // Passes that are kept: who draws more samples of a tile at once makes them again and again.
    static constexpr int kKept = 32;
    // Rays that all passes made so far have sent.
    std::uint64_t rays_sent() const;
    // Of the search in pass `index`, mm.
    double radius(int index) const;
    // The pass of a sample: all have the same where it is made once.
    int number_of(int sample) const { return plan_.once ? 0 : sample; }

private:
    std::shared_ptr<const LightPass> made(int index) const;
    struct Kept;
    const Stage& stage_;
    PassPlan plan_;
    std::unique_ptr<Kept> kept_;
};

}  // namespace whittle
