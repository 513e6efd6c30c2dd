// tone.h — from radiance to what a screen shows: exposure, tone curve, sRGB, eight bits.
//
// Radiance 1 is white at exposure 0. Source of the sRGB curve: IEC 61966-2-1; of the filmic one: K. Narkowicz's fit of the ACES curve (2015).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "csg/base/vec.h"

namespace whittle {

// kSrgb: clipped at white, sRGB curve. kFilmic: shoulder and toe, sRGB curve. kLinear: clipped, no curve at all.
enum class Tonemap { kSrgb, kFilmic, kLinear };
std::optional<Tonemap> tonemap_named(std::string_view name);

struct Tone {
    double exposure = 0;  // stops
    Tonemap map = Tonemap::kSrgb;
};

// One channel, 0..1 (negative and above 1 by the same formulas).
double srgb_to_linear(double encoded);
double linear_to_srgb(double linear);
Vec3 srgb_to_linear(Vec3 encoded);

// Rec.709 luminance.
inline double luminance(Vec3 linear) { return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z; }

// Turns radiances into eight-bit triples; the exposure's factor and the curve's steps are found once.
class ToneCurve {
public:
    explicit ToneCurve(Tone tone);
    // Appends three bytes: each is the nearest of 256 to the exact curve. NaN gives 0.
    void append(Vec3 radiance, std::vector<std::uint8_t>& bytes) const;

private:
    std::uint8_t byte_of(double radiance) const;

    double factor_;
    Tonemap map_;
    std::vector<double> steps_;         // steps_[k]: the least linear value shown as k + 1
    std::vector<std::uint8_t> guess_;  // byte at the lower end of a cell of linear value
};

}  // namespace whittle
