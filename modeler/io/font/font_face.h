// font_face.h — one face of a font: found by fontconfig, read by FreeType, shaped by HarfBuzz. Private to the module whittle_font.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include <hb.h>

#include "csg/base/result.h"
#include "csg/solid/text_outline.h"

namespace whittle {

template <auto Release>
struct ReleaseBy {
    template <class T>
    void operator()(T* p) const { Release(p); }
};
using PatternPtr = std::unique_ptr<FcPattern, ReleaseBy<FcPatternDestroy>>;
using HbFontPtr = std::unique_ptr<hb_font_t, ReleaseBy<hb_font_destroy>>;
using HbBufferPtr = std::unique_ptr<hb_buffer_t, ReleaseBy<hb_buffer_destroy>>;

struct Face {
    FT_Face face = nullptr;
    std::string name;          // "Family:style=Style"
    bool substituted = false;  // not the family or style that was asked for
    bool symbols = false;      // letters of one byte stand at U+F000 (Webdings and the like)

    Face() = default;
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;
    ~Face() {
        if (face) FT_Done_Face(face);
    }
};

// The face that fontconfig gives for a name as OpenSCAD takes it ("Family:style=Style"; empty: Liberation Sans).
Result<std::unique_ptr<Face>> find_face(FcConfig* config, FT_Library library, const std::string& font);

// A glyph after shaping.
struct ShapedGlyph {
    FT_UInt index = 0;
    Vec2 advance{0}, offset{0};  // in sizes of the text
    FT_BBox box{};               // of the scaled outline, on whole pixels
};
struct ShapedText {
    std::vector<ShapedGlyph> glyphs;
    bool vertical = false;
};

// Shapes the text; the face stays scaled as OpenSCAD scales it. Direction and script are guessed where not given.
Result<ShapedText> shape_text(Face& face, const TextRequest& request);

// The outline of a glyph, in 1e-5 of the size, as set by shape_text, or in the font's own half units.
Result<DrawnFigure> glyph_outline(Face& face, FT_UInt index, GlyphGrid grid);

// Where the origin of the first glyph goes, by halign and valign; and the measures of the whole.
Vec2 text_offset(const ShapedText& text, const TextRequest& request, std::vector<std::string>& warnings);

}  // namespace whittle
