#include "tracer/image/film.h"

#include <array>
#include <cassert>

namespace whittle {

namespace {

struct AovFacts {
    std::string_view name;
    int channels;
};

constexpr std::array<AovFacts, kAovCount> kFacts{{{"depth", 1},
                                                  {"position", 3},
                                                  {"normal", 3},
                                                  {"solid", 1},
                                                  {"surface", 1},
                                                  {"albedo", 3},
                                                  {"spans", 1},
                                                  {"thickness", 1},
                                                  {"certified", 1},
                                                  {"cost", 1},
                                                  {"variance", 1}}};

}  // namespace

std::string_view aov_name(Aov kind) { return kFacts[static_cast<std::size_t>(kind)].name; }

std::optional<Aov> aov_named(std::string_view name) {
    for (std::size_t i = 0; i < kFacts.size(); ++i)
        if (kFacts[i].name == name) return static_cast<Aov>(i);
    return std::nullopt;
}

int aov_channels(Aov kind) { return kFacts[static_cast<std::size_t>(kind)].channels; }

Film::Film(int width_px, int height_px, AovSet kinds)
    : width(width_px), height(height_px), pixels(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px)), aovs(kinds) {
    for (std::size_t i = 0; i < kFacts.size(); ++i)
        if (kinds & aov_bit(static_cast<Aov>(i))) planes[i].resize(pixels.size() * static_cast<std::size_t>(kFacts[i].channels));
}

Vec3 Film::color(std::size_t pixel) const {
    const PixelSums& p = pixels[pixel];
    return p.weight > 0 ? glm::max(p.color / p.weight, Vec3(0)) : Vec3(0);
}

double Film::coverage(std::size_t pixel) const {
    const PixelSums& p = pixels[pixel];
    return p.weight > 0 ? glm::clamp(p.coverage / p.weight, 0.0, 1.0) : 0;
}

std::size_t Film::missing_pixels() const {
    std::size_t missing = 0;
    for (const PixelSums& p : pixels) missing += p.samples == 0;
    return missing;
}

namespace {

void copy_pixel(const Film& from, std::size_t i, Film& to) {
    to.pixels[i] = from.pixels[i];
    for (std::size_t k = 0; k < kFacts.size(); ++k) {
        const std::size_t channels = static_cast<std::size_t>(kFacts[k].channels);
        if (to.planes[k].empty()) continue;
        for (std::size_t c = 0; c < channels; ++c) to.planes[k][i * channels + c] = from.planes[k][i * channels + c];
    }
}

}  // namespace

Film cropped(const Film& film, TileRegion region) {
    Film part(film.width, film.height, film.aovs);
    for (int y = region.y; y < region.y + region.height; ++y)
        for (int x = region.x; x < region.x + region.width; ++x) copy_pixel(film, film.index(x, y), part);
    return part;
}

void merge(Film& whole, const Film& part) {
    assert(whole.width == part.width && whole.height == part.height && whole.aovs == part.aovs);
    for (std::size_t i = 0; i < whole.pixels.size(); ++i)
        if (whole.pixels[i].samples == 0 && part.pixels[i].samples != 0) copy_pixel(part, i, whole);
}

}  // namespace whittle
