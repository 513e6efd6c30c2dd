#include "tracer/light/stage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "tracer/image/tone.h"

namespace whittle {

namespace {

constexpr std::array<std::string_view, 7> kIntegratorNames{"auto", "preview", "whitted", "distributed", "path", "caustics", "cone"};

bool listed(const std::vector<std::string>& names, std::string_view name) { return std::find(names.begin(), names.end(), name) != names.end(); }

Result<void> check(const RenderOptions& o) {
    // A film is held in memory: 2^28 pixels are 16 GiB of sums.
    constexpr double kMostPixels = 0x1p28;
    if (o.width < 1 || o.height < 1 || static_cast<double>(o.width) * o.height > kMostPixels)
        return fail(Fault::kCommand, fmt::format("A picture of {} x {} pixels can't be made", o.width, o.height));
    if (o.samples < 1 || o.light_samples < 1) return fail(Fault::kCommand, "At least one sample is needed");
    if (o.max_depth < 0) return fail(Fault::kCommand, "The depth limit can't be negative");
    if (o.shard.count < 1 || o.shard.index < 0 || o.shard.index >= o.shard.count) return fail(Fault::kCommand, "A shard is k/n with 0 <= k < n");
    if (!o.region) return {};
    const TileRegion& r = *o.region;
    if (r.x < 0 || r.y < 0 || r.width < 1 || r.height < 1 || r.x > o.width - r.width || r.y > o.height - r.height)
        return fail(Fault::kCommand, "The tile lies outside of the picture");
    return {};
}

StageNeeds needs_of(const World& world, const std::vector<LightSource>& lights, const Lens& lens, const RenderOptions& options) {
    StageNeeds n;
    n.shadows = std::any_of(lights.begin(), lights.end(), [](const LightSource& l) { return l.casts_shadow; });
    n.soft_lights = std::any_of(lights.begin(), lights.end(), [](const LightSource& l) { return l.extended(); });
    n.lens = lens.aperture > 0;
    n.see_through = listed(options.disabled_passes, "media");
    for (std::size_t part = 0; part < world.part_count(); ++part)
        for (const Surface& s : world.surfaces(part)) {
            n.see_through = n.see_through || s.see_through();
            n.mirrors = n.mirrors || s.mirrors();
            n.glossy = n.glossy || ((s.metal > 0 || s.clear()) && !s.sharp());
        }
    return n;
}

Integrator cheapest(const StageNeeds& needs, bool studio) {
    if (needs.glossy || needs.lens || (needs.soft_lights && !studio)) return Integrator::kDistributed;
    return Integrator::kWhitted;
}

void add_lights(const RenderScene& scene, Vec3 centre, Stage& stage) {
    for (const Light& light : scene.lights) {
        if (const auto* point = std::get_if<PointLight>(&light.what)) stage.lights.push_back(resolve_light(*point, centre));
        if (const auto* sun = std::get_if<SunLight>(&light.what)) stage.lights.push_back(resolve_light(*sun));
        if (const auto* area = std::get_if<AreaLight>(&light.what)) stage.lights.push_back(resolve_light(*area, centre));
        const auto* around = std::get_if<EnvironmentLight>(&light.what);
        if (!around) continue;
        stage.surroundings = Surroundings::constant(srgb_to_linear(around->color) * std::max(0.0, around->intensity));
        if (!around->file.empty()) stage.warnings.push_back(fmt::format("environment(file=\"{}\") is not supported yet, its color is used", around->file));
    }
    const bool black = std::all_of(stage.lights.begin(), stage.lights.end(), [](const LightSource& l) { return l.emitted == Vec3(0); });
    if (black && stage.surroundings.dark()) stage.warnings.push_back("The lights of the scene are all black");
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
        add_lights(scene, centre_of(bounds), *stage);
    }
    stage->needs = needs_of(stage->world, stage->lights, *lens, options);
    stage->integrator = options.integrator == Integrator::kAuto ? cheapest(stage->needs, studio) : options.integrator;
    if (stage->integrator > Integrator::kPath)
        return fail(Fault::kCommand, fmt::format("--integrator {} is not there yet; there are preview, whitted, distributed, path", integrator_name(stage->integrator)));
    stage->filter = FilterSampler(options.filter);
    stage->thickness_scale = half_diagonal(bounds) / 4;
    stage->program = std::move(program);
    return std::shared_ptr<const Stage>(std::move(stage));
}

}  // namespace whittle
