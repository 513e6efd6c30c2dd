#include "tracer/light/color_scheme.h"

#include <array>

namespace whittle {

namespace {

struct Entry {
    std::string_view name;
    unsigned background, face;  // 0xRRGGBB
};

// The colours as OpenSCAD 2021.01 shows them.
constexpr std::array<Entry, 11> kSchemes{{{"Cornfield", 0xffffe5, 0xf9d72c},
                                          {"Metallic", 0xaaaaff, 0xddddff},
                                          {"Sunset", 0xaa4444, 0xffaaaa},
                                          {"Starnight", 0x000000, 0xffffe0},
                                          {"BeforeDawn", 0x333333, 0xcccccc},
                                          {"Nature", 0xfafafa, 0x16a085},
                                          {"DeepOcean", 0x333333, 0xeeeeee},
                                          {"Solarized", 0xfdf6e3, 0xb58800},
                                          {"Tomorrow", 0xf8f8f8, 0x4271ae},
                                          {"Tomorrow Night", 0x1d1f21, 0x81a2be},
                                          {"Monotone", 0xffffe5, 0xf9d72c}}};

Vec3 color_of(unsigned hex) { return Vec3((hex >> 16) & 0xff, (hex >> 8) & 0xff, hex & 0xff) / 255.0; }

}  // namespace

std::optional<ColorScheme> color_scheme_named(std::string_view name) {
    for (const Entry& e : kSchemes)
        if (e.name == name) return ColorScheme{color_of(e.background), color_of(e.face)};
    return std::nullopt;
}

std::vector<std::string_view> color_scheme_names() {
    std::vector<std::string_view> names;
    for (const Entry& e : kSchemes) names.push_back(e.name);
    return names;
}

}  // namespace whittle
