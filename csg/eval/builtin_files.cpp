// Built-in modules that name fonts or files: which file is meant is found here, it is read when the solid is made.
#include <cctype>

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

// ISO 15924 code of the script: as given, its first four letters; else guessed from the letters. Empty where there are none.
std::string script_of(const Value& given, const std::string& text) {
    if (given.is_string() && given.string().size() >= 4) {
        std::string code(given.string().substr(0, 4));
        for (std::size_t i = 0; i < code.size(); ++i) code[i] = static_cast<char>(i == 0 ? std::toupper(code[i]) : std::tolower(code[i]));
        return code;
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        const unsigned char c = static_cast<unsigned char>(text[i]);
        if (std::isalpha(c) || (c >= 0xC3 && c <= 0xC9)) return "Latn";
        if (c >= 0xCD && c <= 0xCF) return "Grek";
        if (c >= 0xD0 && c <= 0xD3) return "Cyrl";
        if (c >= 0xD6 && c <= 0xD7) return "Hebr";
        if (c >= 0xD8 && c <= 0xDB) return "Arab";
    }
    return {};
}

bool is_true(const Value& v) { return v.is_bool() && v.boolean(); }

}  // namespace

Made make_text(ModuleUse& use) {
    const std::string text = text_or(use[0], ""), script = script_of(use[5], text);
    const char* direction = script == "Hebr" || script == "Arab" ? "rtl" : "ltr";
    std::string csg = fmt::format("text(text = \"{}\", size = {}, spacing = {}, font = \"{}\", direction = \"{}\", language = \"{}\"", text, number_or(use[1], 10),
                                  number_or(use[8], 1), text_or(use[2], ""), text_or(use[3], direction), text_or(use[4], "en"));
    if (!script.empty()) csg += ", script = \"" + script + "\"";
    csg += fmt::format(", halign = \"{}\", valign = \"{}\", {})", text_or(use[6], "left"), text_or(use[7], "baseline"), facets_text(use.machine));
    return scene::Unsupported{"text", csg};
}

Made make_import(ModuleUse& use) {
    scene::Import out;
    const Value& file = use[0].is_undef() ? use[7] : use[0];
    const Value& layer = use[1].is_undef() ? use[8] : use[1];
    out.name = text_or(file, "");
    out.layer = text_or(layer, "");
    if (!out.name.empty()) out.path = use.machine.find_file(use.place, out.name);
    read_vec2(use[3], out.origin);
    if (double scale = 0; read_number(use[4], scale) && scale > 0) out.scale = scale;
    out.center = is_true(use[9]);
    if (double dpi = 0; read_number(use[10], dpi)) {
        if (dpi > 0.001) out.dpi = dpi;
        else use.machine.warn(use.place, fmt::format("Invalid dpi value giving for import of \"{}\": {:g}", out.name, dpi));
    }
    const std::string shown = out.name.empty() ? std::string() : use.machine.name_of_file(out.path);
    const std::string sheet = suffix_of(out.path) == ".svg" ? fmt::format(", center = {}, dpi = {:g}", out.center, out.dpi) : std::string();
    out.csg = fmt::format("import(file = \"{}\", layer = \"{}\", origin = [{:g}, {:g}]{}, scale = {}, convexity = {}, {}, timestamp = 0)", shown, out.layer,
                          out.origin.x, out.origin.y, sheet, number_or(use[4], 1), read_convexity(use[2], 1), facets_text(use.machine));
    return out;
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
