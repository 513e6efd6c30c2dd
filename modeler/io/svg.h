// svg.h — the shapes and lines of an SVG as a drawing.
#pragma once

#include <string>

#include "csg/solid/imported.h"

namespace whittle {

// path, rect, circle, ellipse and polygon filled, line, polyline and what a path leaves open as wide as their strokes, under groups and their transforms; y up, the sheet's lower left corner at the origin, millimetres by
// width, height and viewBox (in px of `dpi` where those have no unit), else a unit each. Text, `use` and clipping are not drawn, nor strokes of what is filled; `remarks` count what was passed over.
// kWorld fault where the text is no SVG.
Result<Drawing> read_svg(const std::string& text, const DrawingRequest& request);

}  // namespace whittle
