// builtin_text.cpp — text(): its parameters as OpenSCAD takes them.
#include <cctype>

#include <fmt/format.h>

#include "csg/eval/builtin_module_parts.h"
#include "csg/eval/value_text.h"

namespace whittle {
namespace {

std::string text_or(const Value& v, const char* otherwise) { return v.is_string() ? std::string(v.string()) : otherwise; }
double number_or(const Value& v, double otherwise) { return v.is_number() ? v.number() : otherwise; }

std::string stream(double x) {
    std::string out;
    append_stream_number(out, x);
    return out;
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

std::string csg_of(const TextRequest& r, const std::string& script, const char* direction, const Facets& f) {
    std::string csg = fmt::format("text(text = \"{}\", size = {}, spacing = {}, font = \"{}\", direction = \"{}\", language = \"{}\"", r.text, stream(r.size),
                                  stream(r.spacing), r.font, r.direction.empty() ? direction : r.direction, r.language);
    if (!script.empty()) csg += ", script = \"" + script + "\"";
    return csg + fmt::format(", halign = \"{}\", valign = \"{}\", $fn = {:g}, $fa = {:g}, $fs = {:g})", r.halign, r.valign, f.fn, f.fa, f.fs);
}

}  // namespace

Made make_text(ModuleUse& use) {
    // text size font | direction language script halign valign spacing
    scene::Text out;
    TextRequest& r = out.request;
    r.text = text_or(use[0], "");
    r.size = number_or(use[1], r.size);
    r.font = text_or(use[2], "");
    r.direction = text_or(use[3], "");
    r.language = text_or(use[4], "en");
    r.script = text_or(use[5], "");
    r.halign = text_or(use[6], "left");
    r.valign = text_or(use[7], "baseline");
    r.spacing = number_or(use[8], r.spacing);
    const std::string script = script_of(use[5], r.text);
    out.csg = csg_of(r, script, script == "Hebr" || script == "Arab" ? "rtl" : "ltr", use.machine.facets());
    return out;
}

}  // namespace whittle
