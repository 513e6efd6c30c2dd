#include "tracer/image/tone.h"

#include <cstddef>

#include <sleef.h>

namespace whittle {

std::optional<Tonemap> tonemap_named(std::string_view name) {
    if (name == "srgb") return Tonemap::kSrgb;
    if (name == "filmic") return Tonemap::kFilmic;
    if (name == "linear") return Tonemap::kLinear;
    return std::nullopt;
}

double srgb_to_linear(double encoded) {
    if (encoded <= 0.04045) return encoded / 12.92;
    return Sleef_cinz_powd1_u10purec((encoded + 0.055) / 1.055, 2.4);
}

double linear_to_srgb(double linear) {
    if (linear <= 0.0031308) return 12.92 * linear;
    return 1.055 * Sleef_cinz_powd1_u10purec(linear, 1 / 2.4) - 0.055;
}

Vec3 srgb_to_linear(Vec3 encoded) { return {srgb_to_linear(encoded.x), srgb_to_linear(encoded.y), srgb_to_linear(encoded.z)}; }

namespace {

constexpr std::size_t kGuessCells = 4096;

double filmic(double x) { return (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14); }

}  // namespace

ToneCurve::ToneCurve(Tone tone) : factor_(Sleef_cinz_exp2d1_u10purec(tone.exposure)), map_(tone.map), steps_(255), guess_(kGuessCells + 1) {
    for (std::size_t k = 0; k < 255; ++k) {
        const double encoded = (static_cast<double>(k) + 0.5) / 255;
        steps_[k] = map_ == Tonemap::kLinear ? encoded : srgb_to_linear(encoded);
    }
    std::size_t byte = 0;
    for (std::size_t cell = 0; cell <= kGuessCells; ++cell) {
        while (byte < 255 && static_cast<double>(cell) / kGuessCells >= steps_[byte]) ++byte;
        guess_[cell] = static_cast<std::uint8_t>(byte);
    }
}

std::uint8_t ToneCurve::byte_of(double radiance) const {
    double x = radiance * factor_;
    if (!(x > 0)) return 0;
    if (map_ == Tonemap::kFilmic) x = x < 1e6 ? filmic(x) : 1;
    if (x >= 1) return 255;
    std::size_t byte = guess_[static_cast<std::size_t>(x * kGuessCells)];
    while (byte < 255 && x >= steps_[byte]) ++byte;
    return static_cast<std::uint8_t>(byte);
}

void ToneCurve::append(Vec3 radiance, std::vector<std::uint8_t>& bytes) const {
    bytes.push_back(byte_of(radiance.x));
    bytes.push_back(byte_of(radiance.y));
    bytes.push_back(byte_of(radiance.z));
}

}  // namespace whittle
