// Built-in modules that name files: which file is meant is found here, it is read when the solid is made.
#include <cmath>

#include <fmt/format.h>

#include "csg/eval/builtin_module_parts.h"
#include "csg/eval/imports.h"
#include "csg/eval/value_text.h"

namespace whittle {
namespace {

std::string text_or(const Value& v, const char* otherwise) { return v.is_string() ? std::string(v.string()) : otherwise; }

std::string number_or(const Value& v, double otherwise) {
    std::string out;
    append_stream_number(out, v.is_number() ? v.number() : otherwise);
    return out;
}

std::string facets_text(const Machine& machine) {
    const Facets f = machine.facets();
    return fmt::format("$fn = {:g}, $fa = {:g}, $fs = {:g}", f.fn, f.fa, f.fs);
}

bool is_true(const Value& v) { return v.is_bool() && v.boolean(); }

}  // namespace

Made make_import(ModuleUse& use) {
    scene::Import out;
    const Value& file = use[0].is_undef() ? use[7] : use[0];
    const Value& layer = use[!use[1].is_undef() ? 1 : !use[8].is_undef() ? 8 : 11];  // later versions: id, of an SVG
    out.name = file.is_undef() ? std::string() : use.machine.bare_text_of(file);
    out.layer = text_or(layer, "");
    if (!out.name.empty()) out.path = use.machine.find_file(use.place, out.name);
    read_vec2(use[3], out.origin);
    if (double scale = 0; read_number(use[4], scale) && scale > 0) out.scale = scale;
    out.center = is_true(use[9]);
    if (double dpi = 0; read_number(use[10], dpi)) {
        if (dpi > 0.001) out.dpi = dpi;
        else use.warn(fmt::format("Invalid dpi value giving for import of \"{}\": {:g}", out.name, dpi));
    }
    const std::string shown = out.name.empty() ? std::string() : use.machine.name_of_file(out.path);
    const std::string sheet = suffix_of(out.path) == ".svg" ? fmt::format(", center = {}, dpi = {:g}", out.center, out.dpi) : std::string();
    out.csg = fmt::format("import(file = \"{}\", layer = \"{}\", origin = [{:g}, {:g}]{}, scale = {}, convexity = {}, {}, timestamp = 0)", shown, out.layer,
                          out.origin.x, out.origin.y, sheet, number_or(use[4], 1), read_convexity(use[2], 1), facets_text(use.machine));
    return out;
}

void add_drawing(ModuleUse& use, const Value& file, const Value& layer, const Value& origin, double scale) {
    scene::Import out;
    out.name = text_or(file, "");
    out.layer = text_or(layer, "");
    out.path = use.machine.find_file(use.place, out.name);
    read_vec2(origin, out.origin);
    if (std::isfinite(scale) && scale > 0) out.scale = scale;
    out.csg = fmt::format("import(file = \"{}\", layer = \"{}\", origin = [{:g}, {:g}], scale = {:g}, convexity = 1, {}, timestamp = 0)", use.machine.name_of_file(out.path), out.layer,
                          out.origin.x, out.origin.y, out.scale, facets_text(use.machine));
    use.machine.add_child(use.place, std::move(out));
    use.takes_children = false;
}

Made make_surface(ModuleUse& use) {
    scene::Surface out;
    out.name = text_or(use[0], "");
    if (!out.name.empty()) out.path = use.machine.find_file(use.place, out.name);
    out.center = is_true(use[1]);
    out.invert = is_true(use[3]);
    const std::string shown = out.name.empty() ? std::string() : use.machine.name_of_file(out.path);
    out.csg = fmt::format("surface(file = \"{}\", center = {}, invert = {}, timestamp = 0)", shown, out.center, out.invert);
    return out;
}

}  // namespace whittle
