// Built-in modules that read fonts or files: known, written to .csg, not made into solids yet.
#include <fmt/format.h>

#include "csg/eval/builtin_module_parts.h"
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

}  // namespace

Made make_text(ModuleUse& use) {
    return scene::Unsupported{"text", fmt::format("text(text = \"{}\", size = {}, spacing = {}, font = \"{}\", direction = \"{}\", language = \"{}\", script = \"{}\", "
                                                  "halign = \"{}\", valign = \"{}\", {})",
                                                  text_or(use[0], ""), number_or(use[1], 10), number_or(use[8], 1), text_or(use[2], ""), text_or(use[3], "ltr"),
                                                  text_or(use[4], "en"), text_or(use[5], "Latn"), text_or(use[6], "left"), text_or(use[7], "baseline"),
                                                  facets_text(use.machine))};
}

Made make_import(ModuleUse& use) {
    Vec2 origin{0};
    read_vec2(use[3], origin);
    const Value& file = use[0].is_undef() ? use[7] : use[0];
    const Value& layer = use[1].is_undef() ? use[8] : use[1];
    return scene::Unsupported{"import", fmt::format("import(file = \"{}\", layer = \"{}\", origin = [{:g}, {:g}], scale = {}, convexity = {}, {}, timestamp = 0)",
                                                    text_or(file, ""), text_or(layer, ""), origin.x, origin.y, number_or(use[4], 1), read_convexity(use[2], 1),
                                                    facets_text(use.machine))};
}

Made make_surface(ModuleUse& use) {
    const auto truth = [](const Value& v) { return v.is_bool() && v.boolean(); };
    return scene::Unsupported{"surface", fmt::format("surface(file = \"{}\", center = {}, invert = {}, timestamp = 0)", text_or(use[0], ""), truth(use[1]), truth(use[3]))};
}

}  // namespace whittle
