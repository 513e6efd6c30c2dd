// fonts.h — glyphs of the fonts that the system has: shaping behind a plain interface; the module whittle_font implements it.
//
// FreeType, HarfBuzz and fontconfig cost a program some 20 ms of loading and reading their configuration, so nothing but the module links them, and it is
// opened by the first text() of a scene.
#pragma once

#include "csg/base/result.h"
#include "csg/solid/text_outline.h"

namespace whittle {

class Fonts {
public:
    virtual ~Fonts() = default;
    virtual void add(const std::string& path) = 0;
    virtual Result<TextOutline> text(const TextRequest& request, GlyphGrid grid) = 0;
    virtual Result<FontMetrics> metrics(const std::string& font, double size) = 0;
};

// The module's fonts, opened on the first call; kWorld fault when it is not installed. One user at a time.
Result<Fonts*> system_fonts();
// Has the module been opened?
bool fonts_are_loaded();

}  // namespace whittle
