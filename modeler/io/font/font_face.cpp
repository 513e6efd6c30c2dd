// font_face.cpp — which face a name means.
#include "modeler/io/font/font_face.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>
#include FT_TRUETYPE_IDS_H

namespace whittle {
namespace {

constexpr const char* kDefaultFont = "Liberation Sans:style=Regular";

std::string trimmed(const std::string& text) {
    const auto is_blank = [](unsigned char c) { return std::isspace(c) != 0; };
    const auto first = std::find_if_not(text.begin(), text.end(), is_blank);
    const auto last = std::find_if_not(text.rbegin(), std::make_reverse_iterator(first), is_blank).base();
    return std::string(first, last);
}

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::vector<std::string> strings_of(const FcPattern* pattern, const char* object) {
    std::vector<std::string> out;
    FcChar8* text = nullptr;
    for (int i = 0; FcPatternGetString(pattern, object, i, &text) == FcResultMatch; ++i) out.emplace_back(reinterpret_cast<const char*>(text));
    return out;
}

// Is one of the wishes (all of them generic names such as "sans", or none) among what was found?
bool is_granted(const std::vector<std::string>& wishes, const std::vector<std::string>& found) {
    static constexpr std::array kGeneric{"sans", "sans-serif", "serif", "mono", "monospace"};
    if (wishes.empty()) return true;
    return std::any_of(wishes.begin(), wishes.end(), [&](const std::string& wish) {
        if (std::find(kGeneric.begin(), kGeneric.end(), lower(wish)) != kGeneric.end()) return true;
        return std::any_of(found.begin(), found.end(), [&](const std::string& name) { return lower(name) == lower(wish); });
    });
}

bool try_charmap(FT_Face face, int platform, int encoding) {
    for (int i = 0; i < face->num_charmaps; ++i) {
        const FT_CharMap map = face->charmaps[i];
        if (map->platform_id == platform && (encoding < 0 || map->encoding_id == encoding)) return FT_Set_Charmap(face, map) == 0;
    }
    return false;
}

// Unicode where the font has it, else the next best, in OpenSCAD's order.
void select_charmap(FT_Face face) {
    if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) == 0) return;
    static constexpr std::array<std::array<int, 2>, 7> kOrder{{{TT_PLATFORM_MICROSOFT, TT_MS_ID_UNICODE_CS}, {TT_PLATFORM_ISO, TT_ISO_ID_10646},
                                                               {TT_PLATFORM_APPLE_UNICODE, -1}, {TT_PLATFORM_MICROSOFT, TT_MS_ID_SYMBOL_CS},
                                                               {TT_PLATFORM_MACINTOSH, TT_MAC_ID_ROMAN}, {TT_PLATFORM_ISO, TT_ISO_ID_8859_1},
                                                               {TT_PLATFORM_ISO, TT_ISO_ID_7BIT_ASCII}}};
    for (const auto& [platform, encoding] : kOrder)
        if (try_charmap(face, platform, encoding)) return;
}

bool holds_symbols(FT_Face face) {
    if (!face->charmap || face->charmap->platform_id != TT_PLATFORM_MICROSOFT || face->charmap->encoding_id != TT_MS_ID_SYMBOL_CS) return false;
    FT_UInt index = 0;
    return FT_Get_First_Char(face, &index) >= 0xF000 && index != 0;
}

}  // namespace

Result<std::unique_ptr<Face>> find_face(FcConfig* config, FT_Library library, const std::string& font) {
    const std::string asked = trimmed(font).empty() ? kDefaultFont : trimmed(font);
    const PatternPtr pattern(FcNameParse(reinterpret_cast<const FcChar8*>(asked.c_str())));
    if (!pattern) return fail(Fault::kScene, fmt::format("'{}' is not the name of a font", asked));
    const auto families = strings_of(pattern.get(), FC_FAMILY), styles = strings_of(pattern.get(), FC_STYLE);
    FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(config, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    const PatternPtr match(FcFontMatch(config, pattern.get(), &result));
    FcChar8* file = nullptr;
    int index = 0;
    if (!match || FcPatternGetString(match.get(), FC_FILE, 0, &file) != FcResultMatch || FcPatternGetInteger(match.get(), FC_INDEX, 0, &index) != FcResultMatch)
        return fail(Fault::kWorld, "no font is installed");
    auto out = std::make_unique<Face>();
    if (FT_New_Face(library, reinterpret_cast<const char*>(file), index, &out->face) != 0)
        return fail(Fault::kWorld, fmt::format("cannot read the font file '{}'", reinterpret_cast<const char*>(file)));
    select_charmap(out->face);
    out->symbols = holds_symbols(out->face);
    out->substituted = !is_granted(families, strings_of(match.get(), FC_FAMILY)) || !is_granted(styles, strings_of(match.get(), FC_STYLE));
    out->name = fmt::format("{}:style={}", out->face->family_name ? out->face->family_name : "?", out->face->style_name ? out->face->style_name : "?");
    return out;
}

}  // namespace whittle
