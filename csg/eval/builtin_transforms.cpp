// Built-in modules that change what stands under them: placements, colour, extrusions, offset.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/base/degrees.h"
#include "csg/eval/builtin_module_parts.h"
#include "csg/eval/colors.h"

namespace whittle {
namespace {

bool truth_if_bool(const Value& v) { return v.is_bool() && v.boolean(); }

Placement linear(const double (&m)[9]) { return {{m[0], m[1], m[2], 0, m[3], m[4], m[5], 0, m[6], m[7], m[8], 0}}; }

// Rz * Ry * Rx.
Placement turned(const double (&deg)[3]) {
    const double sx = sind(deg[0]), cx = cosd(deg[0]), sy = sind(deg[1]), cy = cosd(deg[1]), sz = sind(deg[2]), cz = cosd(deg[2]);
    return linear({cy * cz, cz * sx * sy - cx * sz, cx * cz * sy + sx * sz,  //
                   cy * sz, cx * cz + sx * sy * sz, cx * sy * sz - cz * sx,  //
                   -sy, cy * sx, cx * cy});
}

// Rodrigues' rotation about `axis`, of any length. The squared length is divided by once, so that axes along a coordinate stay exact.
Placement turned_about(double deg, Vec3 axis) {
    const double squared = glm::dot(axis, axis);
    if (!(squared > 0)) return {};
    const double c = cosd(deg), s = sind(deg) / std::sqrt(squared);
    const Vec3 k = axis * ((1 - c) / squared), t = axis * s;
    return linear({k.x * axis.x + c, k.x * axis.y - t.z, k.x * axis.z + t.y,  //
                   k.y * axis.x + t.z, k.y * axis.y + c, k.y * axis.z - t.x,  //
                   k.z * axis.x - t.y, k.z * axis.y + t.x, k.z * axis.z + c});
}

}  // namespace

Placement read_rotation(ModuleUse& use, const Value& a, const Value& v) {
    Machine& machine = use.machine;
    if (a.is_vector()) {
        double deg[3] = {0, 0, 0};
        bool good = a.size() <= 3;
        double angle = 0;  // one that is no number takes the value of the next, as in OpenSCAD
        for (std::uint32_t i = std::min(a.size(), 3u); i-- > 0; deg[i] = angle) good = read_number(a[i], angle) && good;
        if (!v.is_undef())
            use.warn(fmt::format("When parameter a is supplied as vector, v is ignored rotate(a={}, v={})", machine.text_of(a), machine.text_of(v)));
        if (!good) use.warn(fmt::format("Problem converting rotate(a={}) parameter", machine.text_of(a)));
        return turned(deg);
    }
    double deg = 0;
    const bool angle = read_number(a, deg);
    Vec3 axis{0, 0, 1};
    const bool about = read_vec3(v, axis, 0);
    if (!v.is_undef() && !about) {
        if (angle) use.warn(fmt::format("Problem converting rotate(..., v={}) parameter", machine.text_of(v)));
        else use.warn(fmt::format("Problem converting rotate(a={}, v={}) parameter", machine.text_of(a), machine.text_of(v)));
    } else if (!angle) {
        use.warn(fmt::format("Problem converting rotate(a={}) parameter", machine.text_of(a)));
    }
    return turned_about(deg, axis);
}

Made make_translate(ModuleUse& use) {
    Vec3 v{0};
    if (!read_vec3(use[0], v, 0))
        use.warn(fmt::format("Unable to convert translate({}) parameter to a vec3 or vec2 of numbers", use.machine.text_of(use[0])));
    return scene::Transform{Placement::translation(v)};
}

Made make_rotate(ModuleUse& use) { return scene::Transform{read_rotation(use, use[0], use[1])}; }

Made make_scale(ModuleUse& use) {
    Vec3 s{1};
    double all = 1;
    if (read_number(use[0], all)) s = Vec3(all);
    else if (!read_vec3(use[0], s, 1)) {
        use.warn(fmt::format("Unable to convert scale({}) parameter to a number, a vec3 or vec2 of numbers or a number", use.machine.text_of(use[0])));
        const bool three = use[0].is_vector() && use[0].size() == 3;
        for (std::uint32_t i = 0; three && i < 3 && read_number(use[0][i], s[static_cast<int>(i)]); ++i) {}  // what stands before one that is no number counts
    }
    return scene::Transform{linear({s.x, 0, 0, 0, s.y, 0, 0, 0, s.z})};
}

Made make_mirror(ModuleUse& use) {
    Vec3 n{1, 0, 0};
    if (!read_vec3(use[0], n, 0))
        use.warn(fmt::format("Unable to convert mirror({}) parameter to a vec3 or vec2 of numbers", use.machine.text_of(use[0])));
    const double squared = glm::dot(n, n);
    if (!(squared > 0)) return scene::Transform{};
    const auto entry = [&](int i, int j) { return (i == j ? 1.0 : 0.0) - 2 * n[i] * n[j] / squared; };
    return scene::Transform{linear({entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 0), entry(1, 1), entry(1, 2), entry(2, 0), entry(2, 1), entry(2, 2)})};
}

Made make_multmatrix(ModuleUse& use) {
    double m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const Value& rows = use[0];
    if (rows.is_vector())
        for (std::uint32_t i = 0; i < std::min(rows.size(), 4u); ++i)
            for (std::uint32_t j = 0; rows[i].is_vector() && j < std::min(rows[i].size(), 4u); ++j) read_number(rows[i][j], m[4 * i + j]);
    scene::Transform out;
    const double w = m[15] == 0 ? 1 : m[15];
    for (std::size_t i = 0; i < 12; ++i) out.placement.m[i] = m[i] / w;
    return out;
}

Made make_resize(ModuleUse& use) {
    scene::Resize out;
    if (use[0].is_vector())
        for (std::uint32_t i = 0; i < std::min(use[0].size(), 3u); ++i) read_number(use[0][i], out.size[static_cast<int>(i)]);
    if (use[1].is_vector()) {
        for (std::uint32_t i = 0; i < std::min(use[1].size(), 3u); ++i) out.automatic[i] = use[1][i].truth();
    } else if (use[1].is_bool()) {
        out.automatic.fill(use[1].boolean());
    }
    out.convexity = read_convexity(use[2], 0);
    return out;
}

std::optional<Vec4> read_color(ModuleUse& use, const Value& value) {
    if (value.is_vector()) {
        Vec4 out{1};
        for (std::uint32_t i = 0; i < std::min(value.size(), 4u); ++i) {
            const double c = value[i].is_number() ? value[i].number() : 0;
            if (!(c >= 0 && c <= 1))
                use.warn(fmt::format("color() expects numbers between 0.0 and 1.0. Value of {:.1f} is out of range", c));
            out[static_cast<int>(i)] = c;
        }
        return out;
    }
    if (!value.is_string()) return std::nullopt;
    const std::optional<Vec4> color = color_of_text(value.string());
    if (!color) use.machine.warn(use.place, fmt::format("Unable to parse color \"{}\"", value.string()), nearest_color(value.string()));
    return color;
}

Made make_color(ModuleUse& use) {
    scene::Color out{Vec4{-1, -1, -1, 1}};
    if (const std::optional<Vec4> c = read_color(use, use[0])) out.rgba = *c;
    if (use[1].is_number()) out.rgba.w = use[1].number();
    return out;
}

namespace {

// The arguments of linear_extrude, each where one of the two orders of positions puts it. 2021.01: file layer height origin scale center twist slices, of which
// `file` may be the height; later versions: height v scale center twist slices segments, known by the vector in the second place.
struct ExtrudeArguments {
    explicit ExtrudeArguments(const ModuleUse& use)
        : height(&use[use[2].is_undef() ? (use[10].is_undef() ? 0u : 10u) : 2u]), way(&use[9]), scale(&use[4]), center(&use[5]), twist(&use[6]), slices(&use[7]), segments(&use[11]) {
        if (!use[0].is_number() || !use[1].is_vector()) return;
        height = &use[use[10].is_undef() ? 0 : 10];
        way = &use[1];
        if (use[2].is_undef()) return;
        scale = &use[2], center = &use[3], twist = &use[4], slices = &use[5];
        if (use[11].is_undef()) segments = &use[6];
    }
    const Value *height, *way, *scale, *center, *twist, *slices, *segments;
};

// A drawing in place of the children; an empty name is none.
bool names_file(const Value& value) { return value.is_string() && !value.string().empty(); }

// A whole number above 0, as OpenSCAD takes it: truncated; nothing for others.
std::optional<int> read_count(const Value& value) {
    double count = 0;
    if (read_number(value, count) && std::fabs(count) < 1e9 && static_cast<int>(count) > 0) return static_cast<int>(count);
    return std::nullopt;
}

}  // namespace

Made make_linear_extrude(ModuleUse& use) {
    // file layer height origin scale center twist slices | convexity v h segments
    scene::LinearExtrude out;
    const ExtrudeArguments given(use);
    if (use[0].is_string() || use[1].is_string())
        use.machine.say(Severity::kDeprecated, {}, "Support for reading files in linear_extrude will be removed in future releases. Use a child import() instead.");
    const Value& height = *given.height;
    if (height.is_number() && std::isfinite(height.number())) out.height = height.number();
    if (Vec3 v{0}; read_vec3(*given.way, v, 0)) {  // the way of the sweep; a height beside it sets its length
        const double length = glm::length(v);
        if (length > 0 && height.is_number()) v *= out.height / length;
        out.height = v.z;
        if (v.z > 0) out.lean = {v.x / v.z, v.y / v.z};
    }
    if (!(out.height > 0)) out.height = 0;
    out.center = truth_if_bool(*given.center);
    double twist = 0;
    if (read_number(*given.twist, twist)) out.twist_deg = twist;
    double all = 1;
    if (read_number(*given.scale, all)) out.scale = Vec2(all);
    else read_vec2(*given.scale, out.scale);
    out.scale = {std::max(out.scale.x, 0.0), std::max(out.scale.y, 0.0)};
    out.slices = read_count(*given.slices);
    out.segments = read_count(*given.segments).value_or(0);
    out.convexity = read_convexity(use[8], 1);
    if (names_file(use[0])) add_drawing(use, use[0], use[1], use[3], out.scale.x);
    return out;
}

Made make_rotate_extrude(ModuleUse& use) {
    // file layer origin scale | convexity angle start a
    scene::RotateExtrude out;
    if (use[0].is_string()) {
        use.machine.say(Severity::kDeprecated, {}, "Support for reading files in rotate_extrude will be removed in future releases. Use a child import() instead.");
        double scale = 1;
        read_number(use[3], scale);
        if (names_file(use[0])) add_drawing(use, use[0], use[1], use[2], scale);
    }
    const Value& angle = !use[5].is_undef() ? use[5] : !use[7].is_undef() ? use[7] : use[0];
    double deg = 360;
    if (read_number(angle, deg)) out.angle_deg = deg <= -360 || deg > 360 ? 360 : deg;
    // A full turn starts on -x, a part of one on +x.
    out.start_deg = out.angle_deg == 360 ? 180 : 0;
    double start = 0;
    if (read_number(use[6], start)) out.start_deg = start;
    out.convexity = read_convexity(use[4], 2);
    return out;
}

Made make_offset(ModuleUse& use) {
    scene::Offset out;
    double r = 1;
    if (read_number(use[0], r) || !use[1].is_number()) {
        out.delta = r;
    } else {
        out.round = false;
        out.delta = use[1].number();
        out.chamfer = truth_if_bool(use[2]);
    }
    return out;
}

}  // namespace whittle
