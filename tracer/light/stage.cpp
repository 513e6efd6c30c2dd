#include "tracer/light/stage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "csg/base/passes.h"
#include "tracer/image/tone.h"
#include "tracer/light/light_pass.h"

namespace whittle {

namespace {

constexpr std::array<std::string_view, 7> kIntegratorNames{"auto", "preview", "whitted", "distributed", "path", "caustics", "cone"};

Result<void> check(const RenderOptions& o) {
    // A film is held in memory: 2^28 pixels are 16 GiB of sums.
    constexpr double kMostPixels = 0x1p28;
    if (o.width < 1 || o.height < 1 || static_cast<double>(o.width) * o.height > kMostPixels)
        return fail(Fault::kCommand, fmt::format("A picture of {} x {} pixels can't be made", o.width, o.height));
    if (o.samples < 1 || o.light_samples < 1) return fail(Fault::kCommand, "At least one sample is needed");
    if (o.photons < 0) return fail(Fault::kCommand, "The number of photons can't be negative");
    if (o.max_depth < 0) return fail(Fault::kCommand, "The depth limit can't be negative");
    if (o.shard.count < 1 || o.shard.index < 0 || o.shard.index >= o.shard.count) return fail(Fault::kCommand, "A shard is k/n with 0 <= k < n");
    if (!o.region) return {};
    const TileRegion& r = *o.region;
    if (r.x < 0 || r.y < 0 || r.width < 1 || r.height < 1 || r.x > o.width - r.width || r.y > o.height - r.height)
        return fail(Fault::kCommand, "The tile lies outside of the picture");
    return {};
}

bool moves(const Solid& solid) {
    if (solid.root().motion != 0) return true;
    for (NodeId id = 0; id < solid.node_count(); ++id) {
        const auto* combination = std::get_if<Combination>(&solid.node(id));
        if (combination && std::any_of(combination->operands.begin(), combination->operands.end(), [](const Use& use) { return use.motion != 0; })) return true;
    }
    return false;
}

StageNeeds needs_of(const World& world, const std::vector<LightSource>& lights, const Lens& lens, const Solid* solid) {
    StageNeeds n;
    n.shutter = solid && moves(*solid);
    bool focuses = false, receives = false;
    n.shadows = std::any_of(lights.begin(), lights.end(), [](const LightSource& l) { return l.casts_shadow && l.emitted != Vec3(0); });
    n.soft_lights = std::any_of(lights.begin(), lights.end(), [](const LightSource& l) { return l.extended(); });
    n.lens = lens.aperture > 0;
    for (std::size_t part = 0; part < world.part_count(); ++part)
        for (const Surface& s : world.surfaces(part)) {
            n.see_through = n.see_through || s.see_through();
            n.mirrors = n.mirrors || s.mirrors();
            n.glossy = n.glossy || ((s.metal > 0 || s.clear()) && !s.sharp());
            n.spectrum = n.spectrum || (s.clear() && s.abbe > 0);
            focuses = focuses || s.focuses();
            receives = receives || s.receives();
        }
    const bool lamps = std::any_of(lights.begin(), lights.end(), [](const LightSource& l) { return l.emitted != Vec3(0); });
    n.photons = lamps && focuses && receives;
    return n;
}

// What passes that are switched off would have left out. The choice of the integrator is behind us, and no byte depends on this.
void need_in_vain(const std::vector<std::string>& disabled, StageNeeds& n) {
    n.dark_lamps = is_disabled(disabled, "shadows");
    n.sizeless = is_disabled(disabled, "areas");
    n.see_through = n.see_through || is_disabled(disabled, "media");
    n.lens = n.lens || is_disabled(disabled, "lens");
    n.shutter = n.shutter || is_disabled(disabled, "shutter");
    n.soft_lights = n.soft_lights || n.sizeless;
}

struct Choice {
    Integrator integrator = Integrator::kWhitted;
    std::string reason;
};

// In the studio lamps are no things and throw no caustics. `tree`: photons of its own are asked for, so caustics are seen without paths.
Choice cheapest(const StageNeeds& needs, bool studio, bool tree) {
    if (needs.photons && !studio && !tree) return {Integrator::kCaustics, "lamps shine through clear matter or off mirrors"};
    if (needs.shutter) return {Integrator::kDistributed, "something moves"};
    if (needs.lens) return {Integrator::kDistributed, "the lens has an aperture"};
    if (needs.spectrum) return {Integrator::kDistributed, "matter disperses light"};
    if (needs.glossy) return {Integrator::kDistributed, "mirrors or clear matter are rough"};
    if (needs.soft_lights && !studio) return {Integrator::kDistributed, "lights have a size"};
    return {Integrator::kWhitted, studio ? "all mirrors are sharp" : "all mirrors are sharp and all shadows hard"};
}

// Scales that are no number or negative are darkness; those without end are very bright.
double scale_of(double intensity) {
    constexpr double kBrightest = 1e9;
    return intensity > 0 ? std::min(intensity, kBrightest) : 0;
}

Result<void> add_environment(const RenderScene& scene, const EnvironmentLight& light, const SourcePlace& place, Stage& stage) {
    const Vec3 tint = srgb_to_linear(light.color) * scale_of(light.intensity);
    stage.surroundings = Surroundings::constant(tint);
    if (light.file.empty()) return {};
    if (!scene.read_picture) return fail(Fault::kScene, fmt::format("environment(file=\"{}\") can't be read here", light.file));
    const Result<Image> image = scene.read_picture(light.file, place);
    if (!image) return tl::unexpected<Error>(image.error());
    if (image->width < 1 || image->height < 1 || image->floats.empty()) return fail(Fault::kScene, fmt::format("\"{}\" holds no picture", light.file));
    std::size_t mended = 0;
    auto map = std::make_shared<const EnvironmentMap>(*image, tint, light.rotate_deg, mended);
    if (mended > 0) stage.warnings.push_back(fmt::format("{} pixels of \"{}\" are negative, infinite or no numbers: they give no light, or the most there is", mended, light.file));
    stage.surroundings = Surroundings::picture(map);
    if (map->dark()) return {};
    LightSource lamp;
    lamp.kind = LightKind::kEnvironment;
    lamp.emitted = tint;
    lamp.map = std::move(map);
    stage.lights.push_back(std::move(lamp));
    return {};
}

Result<void> add_lights(const RenderScene& scene, Vec3 centre, Stage& stage) {
    for (const Light& light : scene.lights) {
        if (const auto* point = std::get_if<PointLight>(&light.what)) stage.lights.push_back(resolve_light(*point, centre));
        if (const auto* sun = std::get_if<SunLight>(&light.what)) stage.lights.push_back(resolve_light(*sun));
        if (const auto* area = std::get_if<AreaLight>(&light.what)) stage.lights.push_back(resolve_light(*area, centre));
        const auto* around = std::get_if<EnvironmentLight>(&light.what);
        if (!around) continue;
        if (const Result<void> added = add_environment(scene, *around, light.place, stage); !added) return added;
    }
    const bool black = std::all_of(stage.lights.begin(), stage.lights.end(), [](const LightSource& l) { return l.emitted == Vec3(0); });
    if (black && stage.surroundings.dark()) stage.warnings.push_back("The lights of the scene are all black");
    return {};
}

// Only integrators that sample areas draw from a picture of surroundings; the others look at it smoothed. A lamp without light gets no shadow rays.
void drop_lamps(Stage& stage) {
    const auto useless = [&stage](const LightSource& l) {
        return (l.kind == LightKind::kEnvironment && !stage.distributes()) || (l.emitted == Vec3(0) && !stage.needs.dark_lamps);
    };
    stage.lights.erase(std::remove_if(stage.lights.begin(), stage.lights.end(), useless), stage.lights.end());
}

// Of the tree of mirrors and refractions: one for all samples, as long as nothing moves.
PassPlan plan_of_tree(const Stage& stage) {
    const RenderOptions& o = stage.options;
    const bool once = !stage.needs.shutter || !stage.distributes() || o.samples == 1;
    return {once ? o.photons : std::max(1, o.photons / o.samples), PassPlan::Draws::kNothing, once, o.photons};
}

// Of paths: as many rays as pixels, so that lamp and eye share the work; enough for small pictures, not too many to be held.
PassPlan plan_of_paths(const RenderOptions& o) {
    constexpr double kFewest = 0x1p14, kMost = 0x1p18;
    const double pixels = static_cast<double>(o.width) * o.height;
    return {static_cast<int>(std::clamp(pixels, kFewest, kMost)), o.trace_onto_picture ? PassPlan::Draws::kOntoPicture : PassPlan::Draws::kNothing, false, 0};
}

void add_light_passes(const Bounds& bounds, bool studio, Stage& stage) {
    const bool paths = stage.integrator == Integrator::kCaustics, tree = !paths && stage.options.photons > 0;
    if ((!paths && !tree) || studio) return;
    const bool in_vain = is_disabled(stage.options.disabled_passes, "photons") && !stage.needs.photons;
    if (!stage.needs.photons && !in_vain) return;
    stage.emission = Emission(stage.lights, aims_around(in_vain ? std::vector<Bounds>{bounds} : stage.world.focusing_bounds()), bounds);
    if (!stage.emission.shines()) return;
    stage.light_passes = std::make_shared<const LightPasses>(stage, tree ? plan_of_tree(stage) : plan_of_paths(stage.options));
}

double half_diagonal(const Bounds& b) {
    const double length = glm::length(b.hi - b.lo) / 2;
    return !b.empty() && std::isfinite(length) && length > 0 ? length : 1;
}

Vec3 centre_of(const Bounds& b) {
    const Vec3 centre = b.lo + (b.hi - b.lo) * 0.5;
    const bool usable = !b.empty() && std::isfinite(centre.x) && std::isfinite(centre.y) && std::isfinite(centre.z);
    return usable ? centre : Vec3(0);
}

}  // namespace

std::string_view integrator_name(Integrator kind) { return kIntegratorNames[static_cast<std::size_t>(kind)]; }

std::optional<Integrator> integrator_named(std::string_view name) {
    const auto found = std::find(kIntegratorNames.begin(), kIntegratorNames.end(), name);
    if (found == kIntegratorNames.end()) return std::nullopt;
    return static_cast<Integrator>(found - kIntegratorNames.begin());
}

Result<std::shared_ptr<const Stage>> prepare(std::shared_ptr<const Program> program, const RenderScene& scene, const RenderOptions& options) {
    if (const Result<void> sane = check(options); !sane) return tl::unexpected<Error>(sane.error());
    const Bounds bounds = program_bounds(*program);
    const double aspect = static_cast<double>(options.width) / options.height;
    const Result<Lens> lens = resolve_camera(scene.camera_spec, scene.camera, scene.view, bounds, aspect);
    if (!lens) return tl::unexpected<Error>(lens.error());
    Result<std::vector<Surface>> surfaces = resolve_surfaces(leaf_uses(*program));
    if (!surfaces) return tl::unexpected<Error>(surfaces.error());
    Result<World> world = World::make(program, scene.solid);
    if (!world) return tl::unexpected<Error>(world.error());
    auto stage = std::make_shared<Stage>();
    stage->world = std::move(*world);
    stage->options = options;
    stage->lens = *lens;
    stage->surfaces = std::move(*surfaces);
    const bool studio = scene.lights.empty();
    if (studio) {
        stage->lights = studio_lamps(*lens);
        stage->surroundings = Surroundings::studio(*lens);
    } else {
        if (const Result<void> added = add_lights(scene, centre_of(bounds), *stage); !added) return tl::unexpected<Error>(added.error());
    }
    stage->needs = needs_of(stage->world, stage->lights, *lens, scene.solid);
    const Choice choice = cheapest(stage->needs, studio, options.photons > 0);
    stage->integrator = options.integrator == Integrator::kAuto ? choice.integrator : options.integrator;
    if (options.integrator == Integrator::kAuto) stage->reason = choice.reason;
    if (options.photons > 0 && stage->integrator != Integrator::kWhitted && stage->integrator != Integrator::kDistributed)
        return fail(Fault::kCommand, "--photons goes with --integrator whitted or distributed");
    stage->noise = options.noise.value_or(stage->distributes() ? 0 : kOwnNoise);
    need_in_vain(options.disabled_passes, stage->needs);
    drop_lamps(*stage);
    if ((stage->needs.spectrum || is_disabled(options.disabled_passes, "spectrum")) && stage->distributes()) stage->spectrum = std::make_unique<const Spectrum>();
    add_light_passes(bounds, studio, *stage);
    if (stage->integrator == Integrator::kCone) stage->world.know_whole(*program);
    if (stage->shows_scheme()) stage->world.recolor(*options.scheme);
    stage->packets = !is_disabled(options.disabled_passes, "packets");
    stage->filter = FilterSampler(options.filter);
    stage->thickness_scale = half_diagonal(bounds) / 4;
    stage->program = std::move(program);
    return std::shared_ptr<const Stage>(std::move(stage));
}

}  // namespace whittle
