#include "tracer/light/color_scheme.h"

#include <array>

namespace whittle {

namespace {

struct Entry {
    std::string_view name;
    unsigned background, face, cut;  // 0xRRGGBB
};

// The colours as OpenSCAD 2021.01 shows them.
constexpr std::array<Entry, 11> kSchemes{{{"Cornfield", 0xffffe5, 0xf9d72c, 0x9dcb51},
                                          {"Metallic", 0xaaaaff, 0xddddff, 0xdd22dd},
                                          {"Sunset", 0xaa4444, 0xffaaaa, 0x882233},
                                          {"Starnight", 0x000000, 0xffffe0, 0x00ffff},
                                          {"BeforeDawn", 0x333333, 0xcccccc, 0x5563dd},
                                          {"Nature", 0xfafafa, 0x16a085, 0xdbf4da},
                                          {"DeepOcean", 0x333333, 0xeeeeee, 0x0babc8},
                                          {"Solarized", 0xfdf6e3, 0xb58800, 0x882233},
                                          {"Tomorrow", 0xf8f8f8, 0x4271ae, 0xf5871f},
                                          {"Tomorrow Night", 0x1d1f21, 0x81a2be, 0xde935f},
                                          {"Monotone", 0xffffe5, 0xf9d72c, 0xf9d72c}}};

Vec3 color_of(unsigned hex) { return Vec3((hex >> 16) & 0xff, (hex >> 8) & 0xff, hex & 0xff) / 255.0; }

}  // namespace

std::optional<ColorScheme> color_scheme_named(std::string_view name) {
    for (const Entry& e : kSchemes)
        if (e.name == name) return ColorScheme{color_of(e.background), color_of(e.face), color_of(e.cut)};
    return std::nullopt;
}

std::vector<std::string_view> color_scheme_names() {
    std::vector<std::string_view> names;
    for (const Entry& e : kSchemes) names.push_back(e.name);
    return names;
}

}  // namespace whittle
