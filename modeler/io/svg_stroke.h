// svg_stroke.h — open lines of an SVG as the area that a pen of some width covers.
#pragma once

#include "modeler/io/outline_builder.h"

namespace whittle {

enum class LineCap { kButt, kRound, kSquare };
enum class LineJoin { kMiter, kRound, kBevel };
// A pen: `width` in user units, more than 0.
struct Pen {
    double width = 1;
    LineCap cap = LineCap::kSquare;
    LineJoin join = LineJoin::kMiter;
};

// Figures whose union is what the pen covers along `line`, whose sides stand in user units and whose end need not be its start; `map` takes them to the drawing. Sides that bend are
// followed by chords within a 128th of the width. Corners are OpenSCAD's: a mitre longer than the width, and every bevel, is cut off at half the width from the corner.
// A line without length gives nothing.
std::vector<DrawnFigure> stroked(const DrawnContour& line, const Pen& pen, const PlaneMap& map);

}  // namespace whittle
