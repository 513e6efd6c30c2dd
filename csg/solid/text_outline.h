// text_outline.h — text as outlines: what text() asks of the outside, and what comes back.
//
// Shaping and fonts are the outside's (modeler/io); what becomes of a curve, chords or the curve itself, is decided by who asks.
#pragma once

#include <string>
#include <vector>

#include "csg/base/vec.h"
#include "csg/solid/imported.h"

namespace whittle {

// The parameters of text(), as the author gave them; empty direction and script are found from the letters.
struct TextRequest {
    std::string text;
    double size = 10, spacing = 1;
    std::string font, direction, language = "en", script, halign = "left", valign = "baseline";
    bool operator==(const TextRequest&) const = default;
};

// Whose coordinates the outlines have: the font's own, or those that OpenSCAD sees (rounded to 1e-5 of the size).
enum class GlyphGrid { kFont, kOpenScad };

struct TextGlyph {
    std::size_t outline = 0;  // index into TextOutline::outlines
    Vec2 at{0};               // of its origin, in mm
};

// Where the text stands, in mm: box of its ink, farthest reach above and below the base line, shift by halign and valign, and where a next text would start.
struct TextMetrics { Vec2 position{0}, size{0}, offset{0}, advance{0}; double ascent = 0, descent = 0; };

struct TextOutline {
    std::vector<DrawnFigure> outlines;  // each glyph once: whole numbers, in units of unit_mm
    std::vector<TextGlyph> glyphs;
    double unit_mm = 1;
    TextMetrics metrics;
    std::string font;           // family and style that were found
    bool substituted = false;   // they are not those asked for
    std::vector<std::string> warnings;
};

// In mm for the size asked.
struct FontMetrics {
    double nominal_ascent = 0, nominal_descent = 0, max_ascent = 0, max_descent = 0, interline = 0;
    std::string family, style;
};

}  // namespace whittle
