// words.cpp — the forms, one function each.
#include "modeler/cli/words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "modeler/cli/numbers.h"

namespace whittle {

namespace {

constexpr double kMostPixels = 65536, kMostShards = 1e6, kMostSides = 1e9;

bool is_whole(double x, double least, double most) { return x >= least && x <= most && x == std::floor(x); }

// Exactly `count` whole numbers in [least, kMostPixels].
std::optional<std::vector<int>> pixels_in(const std::string& text, std::size_t count, double least) {
    const auto numbers = numbers_in(text);
    if (!numbers || numbers->size() != count) return std::nullopt;
    std::vector<int> pixels;
    for (const double x : *numbers) {
        if (!is_whole(x, least, kMostPixels)) return std::nullopt;
        pixels.push_back(static_cast<int>(x));
    }
    return pixels;
}

}  // namespace

bool read_view(const std::string& text, bool& edges) {
    static constexpr std::array kKnown{"axes", "crosshairs", "edges", "scales", "wireframe"};
    const auto words = words_in(text);
    edges = std::find(words.begin(), words.end(), "edges") != words.end();
    return std::all_of(words.begin(), words.end(), [](const std::string& word) { return std::find(kKnown.begin(), kKnown.end(), word) != kKnown.end(); });
}

std::vector<std::string> words_in(const std::string& text) {
    std::vector<std::string> words;
    std::size_t begin = 0;
    while (true) {
        const auto comma = text.find(',', begin);
        words.push_back(text.substr(begin, comma - begin));
        if (comma == std::string::npos) return words;
        begin = comma + 1;
    }
}

bool read_curves(const std::string& text, CanonicaliseOptions& reading) {
    if (text == "auto") return reading.curves = Curves::kAuto, true;
    if (text == "faceted") return reading.curves = Curves::kFaceted, true;
    if (text.rfind("exact", 0) != 0) return false;
    reading.curves = Curves::kExact;
    if (text == "exact") return true;
    const auto n = text[5] == ':' ? number_in(text.substr(6)) : std::nullopt;
    if (!n || !is_whole(*n, 3, kMostSides)) return false;
    reading.exact_threshold = static_cast<int>(*n);
    return true;
}

bool read_size(const std::string& text, int& width, int& height) {
    const auto sides = pixels_in(text, 2, 1);
    if (!sides) return false;
    width = (*sides)[0];
    height = (*sides)[1];
    return true;
}

bool read_camera(const std::string& text, std::vector<double>& numbers) {
    const auto found = numbers_in(text);
    if (!found || (found->size() != 6 && found->size() != 7)) return false;
    numbers = *found;
    return true;
}

bool read_ray(const std::string& text, std::vector<Ray>& rays) {
    const auto n = numbers_in(text);
    if (!n || n->size() != 6) return false;
    Ray ray;
    for (int k = 0; k < 3; ++k) ray.origin[k] = (*n)[static_cast<std::size_t>(k)], ray.direction[k] = (*n)[static_cast<std::size_t>(k) + 3];
    rays.push_back(ray);
    return is_askable(ray);
}

bool read_planes(const std::string& text, AovSet& planes) {
    for (const auto& name : words_in(text)) {
        const auto kind = aov_named(name);
        if (!kind) return false;
        planes |= aov_bit(*kind);
    }
    return true;
}

bool read_clip(const std::string& text, std::vector<std::array<double, 4>>& clips) {
    const auto n = numbers_in(text);
    if (!n || n->size() != 4 || ((*n)[0] == 0 && (*n)[1] == 0 && (*n)[2] == 0)) return false;
    clips.push_back({(*n)[0], (*n)[1], (*n)[2], (*n)[3]});
    return true;
}

bool read_tile(const std::string& text, std::optional<TileRegion>& region) {
    const auto n = pixels_in(text, 4, 0);
    if (!n) return false;
    region = TileRegion{(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
    return region->width > 0 && region->height > 0;
}

bool read_shard(const std::string& text, Shard& shard) {
    const auto slash = text.find('/');
    if (slash == std::string::npos) return false;
    const auto k = number_in(text.substr(0, slash)), n = number_in(text.substr(slash + 1));
    if (!k || !n || !is_whole(*n, 1, kMostShards) || !is_whole(*k, 1, *n)) return false;
    shard = {static_cast<int>(*k) - 1, static_cast<int>(*n)};
    return true;
}

}  // namespace whittle
