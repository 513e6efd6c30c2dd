// builtin_text.cpp — text(): its parameters as OpenSCAD takes them.
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "csg/eval/builtin_module_parts.h"
#include "csg/eval/letter_scripts.h"
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

// ISO 15924 code of the script: the first four letters as given, whatever their case; else that of the letters. What stands for no script stays as given.
std::string script_of(const std::string& given, const std::string& text) {
    if (given.empty()) {
        const std::string found = script_of_letters(text);
        return found == "Zzzz" ? std::string() : found;
    }
    std::string code(given.substr(0, 4));
    if (code.size() < 4 || !std::all_of(code.begin(), code.end(), [](unsigned char c) { return std::isalpha(c); })) return given;
    for (std::size_t i = 0; i < code.size(); ++i) code[i] = static_cast<char>(i == 0 ? std::toupper(code[i]) : std::tolower(code[i]));
    return code == "Zzzz" || code == "Zyyy" || code == "Zinh" ? given : code;
}

// As HarfBuzz reads it, by the first letter; what is no direction is that of the script.
const char* direction_of(const std::string& given, const std::string& script) {
    const int first = given.empty() ? 0 : std::tolower(static_cast<unsigned char>(given[0]));
    for (const char* known : {"ltr", "rtl", "ttb", "btt"})
        if (first == known[0]) return known;
    return is_written_leftwards(script) ? "rtl" : "ltr";
}

std::string csg_of(const TextRequest& r, const std::string& script, const char* direction, const Facets& f) {
    std::string csg = fmt::format("text(text = \"{}\", size = {}, spacing = {}, font = \"{}\", direction = \"{}\", language = \"{}\"", r.text, stream(r.size),
                                  stream(r.spacing), r.font, direction, r.language);
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
    const std::string script = script_of(r.script, r.text);
    out.csg = csg_of(r, script, direction_of(r.direction, script), use.machine.facets());
    return out;
}

}  // namespace whittle
