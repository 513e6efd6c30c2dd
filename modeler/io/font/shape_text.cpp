// shape_text.cpp — letters to glyphs and places, as OpenSCAD 2021.01 lays them out; glyphs to outlines.
//
// OpenSCAD has FreeType scale every face to 100,000/64 points at 100 dots an inch, whatever the size of the text, so that a unit of the outline (1/64
// dot) is 1e-5 of the size; but it divides advances and boxes by 102,400. Letters stand where it puts them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "modeler/io/font/font_face.h"

#include FT_GLYPH_H
#include FT_OUTLINE_H
#include <hb-ft.h>

namespace whittle {
namespace {

constexpr FT_F26Dot6 kCharSize = 100000;
constexpr double kLayoutUnits = 102400;
constexpr unsigned kDotsPerInch = 100;

bool tells_nothing(hb_script_t script) {
    return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN || script == HB_SCRIPT_INVALID;
}

// The one script that all letters have; unknown where they have several, invalid where none tells.
hb_script_t script_of_letters(const std::string& text) {
    const HbBufferPtr buffer(hb_buffer_create());
    hb_buffer_add_utf8(buffer.get(), text.c_str(), static_cast<int>(text.size()), 0, static_cast<int>(text.size()));
    unsigned count = 0;
    const hb_glyph_info_t* letters = hb_buffer_get_glyph_infos(buffer.get(), &count);
    hb_script_t script = HB_SCRIPT_INVALID;
    for (unsigned i = 0; i < count; ++i) {
        const hb_script_t own = hb_unicode_script(hb_unicode_funcs_get_default(), letters[i].codepoint);
        if (tells_nothing(own)) continue;
        if (script == HB_SCRIPT_INVALID) script = own;
        else if (script != own) script = HB_SCRIPT_UNKNOWN;
    }
    return script;
}

void set_properties(hb_buffer_t* buffer, const TextRequest& request) {
    hb_script_t script = hb_script_from_string(request.script.c_str(), -1);
    if (script == HB_SCRIPT_INVALID) script = script_of_letters(request.text);
    hb_direction_t direction = hb_direction_from_string(request.direction.c_str(), -1);
    if (direction == HB_DIRECTION_INVALID) direction = hb_script_get_horizontal_direction(script);
    if (direction == HB_DIRECTION_INVALID) direction = HB_DIRECTION_LTR;
    hb_buffer_set_script(buffer, tells_nothing(script) ? HB_SCRIPT_INVALID : script);
    hb_buffer_set_direction(buffer, direction);
    hb_buffer_set_language(buffer, hb_language_from_string(request.language.c_str(), -1));
}

// Letters of one byte in a font of symbols stand in the private page at U+F000.
void add_letters(hb_buffer_t* buffer, const Face& face, const std::string& text) {
    hb_buffer_add_utf8(buffer, text.c_str(), static_cast<int>(text.size()), 0, static_cast<int>(text.size()));
    if (!face.symbols) return;
    unsigned count = 0;
    hb_glyph_info_t* letters = hb_buffer_get_glyph_infos(buffer, &count);
    for (unsigned i = 0; i < count; ++i)
        if (letters[i].codepoint < 0x100) letters[i].codepoint += 0xF000;
}

Result<FT_BBox> box_of(FT_Face face, FT_UInt index) {
    FT_Glyph glyph = nullptr;
    if (FT_Load_Glyph(face, index, FT_LOAD_DEFAULT) != 0 || FT_Get_Glyph(face->glyph, &glyph) != 0)
        return fail(Fault::kScene, fmt::format("glyph {} of the font cannot be read", index));
    FT_BBox box{};
    FT_Glyph_Get_CBox(glyph, FT_GLYPH_BBOX_GRIDFIT, &box);
    FT_Done_Glyph(glyph);
    return box;
}

// Takes FreeType's outline step by step.
struct Sketch {
    DrawnFigure outline;

    static Vec2 point(const FT_Vector* v) { return {static_cast<double>(v->x), static_cast<double>(v->y)}; }
    void step(int degree, std::array<Vec2, 3> p) {
        if (!outline.contours.empty()) outline.contours.back().sides.push_back({degree, p, 0});
    }
    static Sketch& of(void* user) { return *static_cast<Sketch*>(user); }
    static int move(const FT_Vector* to, void* user) {
        of(user).outline.contours.push_back({point(to), {}});
        return 0;
    }
    static int line(const FT_Vector* to, void* user) {
        of(user).step(1, {point(to)});
        return 0;
    }
    static int conic(const FT_Vector* c, const FT_Vector* to, void* user) {
        of(user).step(2, {point(c), point(to)});
        return 0;
    }
    static int cubic(const FT_Vector* c, const FT_Vector* d, const FT_Vector* to, void* user) {
        of(user).step(3, {point(c), point(d), point(to)});
        return 0;
    }
};

}  // namespace

Result<ShapedText> shape_text(Face& face, const TextRequest& request) {
    if (FT_Set_Char_Size(face.face, 0, kCharSize, kDotsPerInch, kDotsPerInch) != 0) return fail(Fault::kScene, fmt::format("the font {} cannot be scaled", face.name));
    const HbFontPtr font(hb_ft_font_create_referenced(face.face));
    const HbBufferPtr buffer(hb_buffer_create());
    set_properties(buffer.get(), request);
    add_letters(buffer.get(), face, request.text);
    hb_shape(font.get(), buffer.get(), nullptr, 0);
    ShapedText out;
    out.vertical = HB_DIRECTION_IS_VERTICAL(hb_buffer_get_direction(buffer.get()));
    unsigned count = 0;
    const hb_glyph_info_t* glyphs = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(buffer.get(), &count);
    for (unsigned i = 0; i < count; ++i) {
        const auto box = box_of(face.face, glyphs[i].codepoint);
        if (!box) return tl::unexpected(box.error());
        const Vec2 advance{static_cast<double>(places[i].x_advance), static_cast<double>(places[i].y_advance)};
        const Vec2 offset{static_cast<double>(places[i].x_offset), static_cast<double>(places[i].y_offset)};
        out.glyphs.push_back({glyphs[i].codepoint, advance / kLayoutUnits, offset / kLayoutUnits, *box});
    }
    return out;
}

Vec2 text_offset(const ShapedText& text, const TextRequest& request, std::vector<std::string>& warnings) {
    double width = 0, ascent = 0, descent = 0;
    for (const ShapedGlyph& g : text.glyphs) {
        if (text.vertical) {
            width = std::max(width, static_cast<double>(g.box.xMax - g.box.xMin) / kLayoutUnits);
            ascent += g.advance.y * request.spacing;
        } else {
            width += g.advance.x * request.spacing;
            ascent = std::max(ascent, static_cast<double>(g.box.yMax) / kLayoutUnits);
            descent = std::max(descent, static_cast<double>(-g.box.yMin) / kLayoutUnits);
        }
    }
    Vec2 offset(0);
    if (request.halign == "right") offset.x = -width;
    else if (request.halign == "center") offset.x = -width / 2;
    else if (request.halign != "left") warnings.push_back(fmt::format("Unknown value for the halign parameter (use \"left\", \"right\" or \"center\"): '{}'", request.halign));
    if (request.valign == "top") offset.y = -ascent;
    else if (request.valign == "center") offset.y = descent / 2 - ascent / 2;
    else if (request.valign == "bottom") offset.y = descent;
    else if (request.valign != "baseline")
        warnings.push_back(fmt::format("Unknown value for the valign parameter (use \"baseline\", \"bottom\", \"top\" or \"center\"): '{}'", request.valign));
    return offset * request.size;
}

Result<DrawnFigure> glyph_outline(Face& face, FT_UInt index, GlyphGrid grid) {
    const bool own = grid == GlyphGrid::kFont;
    if (FT_Load_Glyph(face.face, index, own ? FT_LOAD_NO_SCALE : FT_LOAD_DEFAULT) != 0 || face.face->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
        return fail(Fault::kScene, fmt::format("glyph {} of the font has no outline", index));
    // Half units: the points between two control points, which the font leaves out, are whole too.
    const FT_Outline_Funcs funcs{Sketch::move, Sketch::line, Sketch::conic, Sketch::cubic, own ? 1 : 0, 0};
    Sketch sketch;
    if (FT_Outline_Decompose(&face.face->glyph->outline, &funcs, &sketch) != 0) return fail(Fault::kScene, fmt::format("glyph {} of the font is broken", index));
    return std::move(sketch.outline);
}

}  // namespace whittle
