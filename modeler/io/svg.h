// svg.h — the filled shapes of an SVG as a drawing.
#pragma once

#include <string>

#include "csg/solid/imported.h"

namespace whittle {

// path, rect, circle, ellipse, polygon and polyline, under groups and their transforms; y up, the sheet's lower left corner at the origin, millimetres by
// width, height and viewBox (in px of `dpi` where those have no unit), else a unit each. Strokes, text and clipping are not drawn; `remarks` count what was passed over.
// kWorld fault where the text is no SVG.
Result<Drawing> read_svg(const std::string& text, const DrawingRequest& request);

}  // namespace whittle
