// picture.cpp — a film becomes the channels of a file.
#include <array>

#include <fmt/format.h>
#include <sleef.h>

#include "tracer/image/image_file.h"

namespace whittle {

namespace {

Image eight_bit_picture(const Film& film, const Tone& tone) {
    Image image;
    image.width = film.width;
    image.height = film.height;
    image.channels = {"R", "G", "B"};
    image.types.assign(3, ChannelType::kByte);
    image.bytes.reserve(film.pixels.size() * 3);
    const ToneCurve curve(tone);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) curve.append(film.color(i), image.bytes);
    return image;
}

void name_channels(const Film& film, ChannelType color_type, Image& image) {
    for (const char* name : {"R", "G", "B", "A"}) image.channels.emplace_back(name);
    image.types.assign(4, color_type);
    for (int k = 0; k < kAovCount; ++k) {
        const Aov kind = static_cast<Aov>(k);
        if (film.planes[k].empty()) continue;
        static constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"}, kColors{"R", "G", "B"};
        const auto& suffixes = kind == Aov::kAlbedo ? kColors : kAxes;
        for (int c = 0; c < aov_channels(kind); ++c) {
            const char* suffix = aov_channels(kind) == 1 ? (kind == Aov::kDepth ? "Z" : "V") : suffixes[static_cast<std::size_t>(c)];
            image.channels.push_back(fmt::format("{}.{}", aov_name(kind), suffix));
            image.types.push_back(ChannelType::kFloat);
        }
    }
}

Image linear_picture(const Film& film, const PictureOptions& options) {
    Image image;
    image.width = film.width;
    image.height = film.height;
    name_channels(film, options.color_type, image);
    const double factor = Sleef_cinz_exp2d1_u10purec(options.tone.exposure);
    image.floats.reserve(film.pixels.size() * image.channels.size());
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
        const Vec3 color = film.color(i) * factor;
        for (int c = 0; c < 3; ++c) image.floats.push_back(static_cast<float>(color[c]));
        image.floats.push_back(static_cast<float>(film.coverage(i)));
        for (int k = 0; k < kAovCount; ++k) {
            if (film.planes[k].empty()) continue;
            const std::size_t channels = static_cast<std::size_t>(aov_channels(static_cast<Aov>(k)));
            for (std::size_t c = 0; c < channels; ++c) image.floats.push_back(film.planes[k][i * channels + c]);
        }
    }
    return image;
}

}  // namespace

Result<Image> image_of(const Film& film, ImageFormat format, const PictureOptions& options) {
    if (format == ImageFormat::kExr) return linear_picture(film, options);
    if (film.aovs != 0) return fail(Fault::kCommand, "--aov needs a picture with room for more channels: use -o FILE.exr");
    return eight_bit_picture(film, options.tone);
}

}  // namespace whittle
