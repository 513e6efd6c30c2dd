// checkpoint.cpp — what a picture depends on, as one number; and the file.
#include "modeler/cli/checkpoint.h"

#include <array>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "csg/base/file.h"
#include "tracer/image/film_file.h"

namespace whittle {

namespace {

// Everything on the command line that can change a pixel, in words. Threads, tone and file names cannot.
std::string words_of(const Request& request) {
    const CommonRequest& common = request.common;
    const RenderRequest& render = request.render;
    const RenderOptions& o = render.options;
    const TileRegion region = o.region.value_or(TileRegion{});
    std::string words = fmt::format("{} {} {} {} {} {} {} {} {} {} {} {:a} {} ", o.width, o.height, o.samples, o.light_samples, o.max_depth, static_cast<int>(o.integrator),
                                    static_cast<int>(o.look), o.edges, static_cast<int>(o.filter), o.aovs, o.seed, o.noise.value_or(-1), fmt::join(o.disabled_passes, ","));
    if (o.photons > 0) words += fmt::format("{} photons ", o.photons);
    if (o.sampler != SamplerKind::kSobol) words += fmt::format("{} ", sampler_name(o.sampler));
    words += fmt::format("{} {} {} {} {}/{} ", region.x, region.y, region.width, region.height, o.shard.index, o.shard.count);
    if (o.scheme)
        for (const Vec3 color : {o.scheme->background, o.scheme->face}) words += fmt::format("{} {} {} ", color.x, color.y, color.z);
    for (const double n : render.camera.numbers) words += fmt::format("{:a} ", n);
    words += fmt::format("{} {} {} ", render.camera.viewall, render.camera.autocenter, render.camera.orthographic.value_or(false));
    for (const auto& clip : render.clips)
        for (const double n : clip) words += fmt::format("{:a} ", n);
    words += fmt::format("{} {} {} {} {:a} ", static_cast<int>(common.reading.curves), common.reading.exact_threshold, common.snap, common.parameter_set, common.time);
    return words + fmt::format("{}", fmt::join(common.definitions, "\n"));
}

// Files the picture comes from beside the texts: imports, the parameters, pictures of surroundings.
std::vector<std::string> files_of(const Session& session, const ReadScene& scene) {
    std::vector<std::string> files = scene.evaluated.files_read;
    if (!session.request.common.parameter_file.empty()) files.push_back(session.request.common.parameter_file);
    const SourceTable& sources = scene.evaluated.sources;
    for (const Light& light : scene.evaluated.scene.lights) {
        const auto* around = std::get_if<EnvironmentLight>(&light.what);
        if (!around || around->file.empty() || light.place.file >= sources.files.size()) continue;
        files.push_back((std::filesystem::path(sources.files[light.place.file].path).parent_path() / around->file).string());
    }
    return files;
}

std::uint64_t fingerprint_of_run(const Session& session, const ReadScene& scene) {
    std::uint64_t print = fingerprint_of(WHITTLE_VERSION);
    print = fingerprint_of(words_of(session.request), print);
    for (const SourceFile& file : scene.evaluated.sources.files) print = fingerprint_of(file.text, print);
    for (const std::string& name : files_of(session, scene)) {
        // One that cannot be read any more makes another number, and so a refusal.
        const auto bytes = name == "-" ? Result<std::string>() : read_whole_file(name);
        print = fingerprint_of(bytes ? *bytes : name, print);
    }
    return print;
}

}  // namespace

Checkpoint::Checkpoint(const Session& session, const ReadScene& scene, const std::string& picture)
    : path_(picture == "-" ? std::string() : picture + ".part"), fingerprint_(fingerprint_of_run(session, scene)) {}

Result<std::optional<Film>> Checkpoint::read() const {
    if (path_.empty() || !std::filesystem::exists(path_)) return std::nullopt;
    const auto bytes = read_whole_file(path_);
    if (!bytes) return fail(Fault::kWorld, fmt::format("Can't open '{}' to resume: {}", path_, bytes.error().message));
    Result<Film> film = film_of_bytes(*bytes, fingerprint_);
    if (!film) return fail(film.error().fault, fmt::format("Can't resume from '{}': {}", path_, film.error().message));
    return std::optional<Film>(std::move(*film));
}

Result<void> Checkpoint::write(const Film& film) const {
    if (path_.empty()) return {};
    auto written = write_file_atomically(path_, film_bytes(film, fingerprint_));
    if (!written) return fail(Fault::kWorld, fmt::format("Can't write '{}': {}", path_, written.error().message));
    return written;
}

void Checkpoint::remove() const {
    std::array<char, 16> head{};
    std::ifstream file(path_, std::ios::binary);
    // Only what is one: the name could be anybody's.
    if (path_.empty() || !file.read(head.data(), head.size()) || !is_film({head.data(), head.size()})) return;
    std::error_code fault;
    std::filesystem::remove(path_, fault);
}

}  // namespace whittle
