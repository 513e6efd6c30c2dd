// render.h — rendering: a pure function of (program, scene, options, tile) to pixels, and the loop around it.
//
// TileDrawer continues the sums of one tile up to sample `end`; everything it reads is immutable, everything it writes is handed in.
// render() calls it over tiles on all cores, in passes of doubling sample counts, so that it can be stopped, watched, resumed and
// shared out. The bytes depend on neither the number of threads nor the passes.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/result.h"
#include "csg/eval/scene.h"
#include "tracer/engine/engine.h"
#include "tracer/image/film.h"
#include "tracer/image/filter.h"
#include "tracer/image/image_file.h"
#include "tracer/light/camera.h"
#include "tracer/light/color_scheme.h"
#include "tracer/light/sampler.h"

namespace whittle {

// In order of cost. kAuto picks the cheapest that shows all matter, light and lens of the scene.
enum class Integrator { kAuto, kPreview, kWhitted, kDistributed, kPath, kCaustics, kCone };
std::string_view integrator_name(Integrator kind);
// "preview", "whitted", ...; "auto" too.
std::optional<Integrator> integrator_named(std::string_view name);

// kXray: brightness falls with the thickness of the solid along the ray.
enum class Look { kShaded, kXray };

// A part of the tiles: those whose number leaves the remainder `index` when divided by `count`.
struct Shard { int index = 0, count = 1; };

// A quarter of a step of eight bits.
inline constexpr double kOwnNoise = 0x1p-10;

// Requires: width, height, samples, light_samples >= 1; max_depth, photons >= 0; 0 <= shard.index < shard.count; region inside the picture.
struct RenderOptions {
    int width = 512, height = 512;
    int samples = 16;
    int light_samples = 1;  // shadow rays a light and hit
    int max_depth = 16;     // mirrors and refractions one after the other
    int photons = 0;        // rays from the lamps that whitted and distributed send once, for caustics; 0: lamps shine straight through what is clear
    Integrator integrator = Integrator::kAuto;
    Look look = Look::kShaded;
    std::optional<ColorScheme> scheme;   // of the preview: background, faces without a colour; other integrators have their studio
    bool edges = false;                  // dark lines at silhouettes and where faces meet at an angle
    FilterKind filter = FilterKind::kGaussian;
    AovSet aovs = 0;
    std::uint64_t seed = 0;
    SamplerKind sampler = SamplerKind::kSobol;
    std::optional<TileRegion> region;    // --tile
    Shard shard;
    // Stop a tile when its estimated error (of display luminance) is below; 0: never. None: kOwnNoise where only places in the pixel are drawn, else never.
    std::optional<double> noise = 0.0;
    double stop_after_s = 0;             // stop after this time, but never within the first pass; 0: never
    int threads = 0;                     // 0: all cores
    std::vector<std::string> disabled_passes;
    // Other estimators of the same picture, to hold one against the other. False: lamps with a size are met by chance only (paths); caustics that the eye
    // sees at once are gathered as photons too.
    bool sample_lamps = true, trace_onto_picture = true;

    Sequence sequence() const { return {sampler, static_cast<std::uint32_t>(samples)}; }
};

// What evaluation found beside the solid.
struct RenderScene {
    std::vector<Light> lights;
    std::optional<Camera> camera;
    ViewVariables view;
    CameraSpec camera_spec;         // the command line's --camera, --viewall ...
    const Solid* solid = nullptr;   // what the program was compiled from; without it overlapping clear matters are not told apart. Read in prepare() only
    // Linear picture of environment(file=...) at a place in the text; null: there are no files.
    std::function<Result<Image>(const std::string& file, const SourcePlace& place)> read_picture;
};

struct RenderProgress {
    double done = 0;  // 0..1 of all samples asked for, those of a resumed film and those that --noise spares among them
    double elapsed_s = 0;
    double left_s = 0;  // at the speed so far; infinite where nothing is drawn yet
};

// Handed in by the caller, read and called by render(). `stop`: finish the first pass, then return what there is. `abort`: return at once.
// `progress` is called from one thread at a time, about ten times a second; `keep` now and then while no thread draws, with what there is so far.
struct RenderControl {
    std::atomic<bool> stop{false};
    std::atomic<bool> abort{false};
    std::function<void(const RenderProgress&)> progress;
    std::function<void(const Film&)> keep;
    double keep_every_s = 60;
};

// Names follow docs/command-line (--stats).
struct RenderCounters {
    std::uint64_t camera = 0, shadow = 0, reflection = 0, refraction = 0, diffuse = 0;
    std::uint64_t photons = 0, media_stack = 0, normals = 0, wavelengths = 0;
    std::uint64_t draws = 0;  // of places on lens and lamps, times, wavelengths
    std::uint64_t skipped_shadows = 0, skipped_media = 0, skipped_lens = 0, skipped_shutter = 0, skipped_spectrum = 0, skipped_photons = 0, skipped_areas = 0;
    std::uint64_t no_numbers = 0;  // samples that came out as no number: they count as dark
    EngineCounters engine;
    RenderCounters& operator+=(const RenderCounters& o);
};

struct RenderResult {
    Film film;
    double exposure = 0;                           // of the scene's camera, in stops: add to --exposure
    Integrator integrator = Integrator::kPreview;  // the one used
    std::string reason;                            // why, where the choice was left to us
    int samples_finished = 0;                      // of every pixel
    int samples_most = 0;                          // of some pixel: others were good enough with fewer
    bool interrupted = false;
    bool complete = false;                         // every tile has its samples, or is good enough
    double seconds = 0;
    RenderCounters counters;
    std::vector<std::string> warnings;
};

// Everything a tile needs: program, resolved matter, lights, lens, sampler. Immutable, shared by all threads.
class Stage;

// kCommand: a camera of neither 6 nor 7 numbers, options out of range, an integrator that is not there.
Result<std::shared_ptr<const Stage>> prepare(std::shared_ptr<const Program> program, const RenderScene& scene, const RenderOptions& options);

// Numbers of samples of the pixels of a tile, row by row of 16.
using TileSamples = std::array<int, 256>;

// The pure function from (stage, tile, samples) to pixels, and the memory that it works in. One a thread.
class TileDrawer {
public:
    // `counters` and `scratch` outlive it.
    TileDrawer(const Stage& stage, Scratch& scratch, RenderCounters& counters);
    ~TileDrawer();
    TileDrawer(const TileDrawer&) = delete;
    TileDrawer& operator=(const TileDrawer&) = delete;

    // Adds samples begin <= i < end to the pixels of `tile`, `begin` being the pixel's own, and its planes where that is 0. `film` is touched
    // in `tile` only. Returns false where `abort` became true: the tile is then as it was.
    bool draw(TileRegion tile, const TileSamples& begins, int end, Film& film, const std::atomic<bool>* abort = nullptr);

private:
    class Work;
    std::unique_ptr<Work> work_;
};

// The tiles of the picture (or of its shard, or those that its region touches), in the order they are drawn.
std::vector<TileRegion> tiles_of(const RenderOptions& options);

// The whole picture; of a region all tiles that it touches, since whether a pixel is good enough depends on those beside it. `resume`: a film of the same
// options whose sums are continued.
Result<RenderResult> render(std::shared_ptr<const Program> program, const RenderScene& scene, const RenderOptions& options, RenderControl& control,
                            const Film* resume = nullptr);

}  // namespace whittle
