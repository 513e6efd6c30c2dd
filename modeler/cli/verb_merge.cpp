// verb_merge.cpp — whittle merge: the shards of one render, put together.
//
// A shard's picture is zero in every channel of the pixels it did not draw, and no pixel is drawn by two shards, so the whole takes each pixel from the
// first part that has anything there.
#include <algorithm>

#include <fmt/core.h>

#include "modeler/cli/answers.h"
#include "modeler/cli/verbs.h"

namespace whittle {

namespace {

Result<void> add_part(Image& whole, const Image& part, const std::string& name) {
    if (part.width != whole.width || part.height != whole.height || part.channels != whole.channels)
        return fail(Fault::kCommand, fmt::format("'{}' has another size or other channels than the first part", name));
    const std::size_t channels = whole.channels.size();
    for (std::size_t begin = 0; begin < whole.floats.size(); begin += channels) {
        const auto drawn = [&](const Image& image) {
            const auto first = image.floats.begin() + static_cast<std::ptrdiff_t>(begin);
            return std::any_of(first, first + static_cast<std::ptrdiff_t>(channels), [](float value) { return value != 0; });
        };
        if (!drawn(whole) && drawn(part)) std::copy_n(part.floats.begin() + static_cast<std::ptrdiff_t>(begin), channels, whole.floats.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    return {};
}

Result<Image> merged(ImageFiles& files, const std::vector<std::string>& paths, ChannelType color_type) {
    std::optional<Image> whole;
    for (const auto& path : paths) {
        auto part = files.read(path);
        if (!part) return part;
        if (!whole) {
            whole = std::move(*part);
            continue;
        }
        if (auto added = add_part(*whole, *part, path); !added) return tl::unexpected<Error>(added.error());
    }
    whole->types.clear();
    for (const auto& channel : whole->channels) whole->types.push_back(channel.size() == 1 ? color_type : ChannelType::kFloat);
    return *std::move(whole);
}

}  // namespace

Exit run_merge(Session& session) {
    const Request& request = session.request;
    const auto all_exr = [](const std::vector<std::string>& paths) {
        return std::all_of(paths.begin(), paths.end(), [](const auto& path) { return image_format_of(path) == ImageFormat::kExr; });
    };
    if (!all_exr(request.inputs) || !all_exr(request.outputs)) return give_up(session, {Fault::kCommand, "merge reads and writes .exr"});
    Stopwatch watch;
    ImageFiles files;
    const auto whole = merged(files, request.inputs, request.render.picture.color_type);
    if (!whole) return give_up(session, whole.error());
    const auto bytes = files.encode(*whole, ImageFormat::kExr);
    if (!bytes) return give_up(session, bytes.error());
    if (auto written = write_output(request.outputs.front(), *bytes); !written) return give_up(session, written.error());
    session.stats.set("loaded.image", files.loaded() ? 1 : 0);
    if (request.common.json)
        fmt::print("{}\n", json::Object().string("file", request.outputs.front()).number("seconds", watch.lap()).strings("warnings", session.console.warnings()).str());
    return Exit::kDone;
}

}  // namespace whittle
