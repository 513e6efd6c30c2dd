// dxf.h — the outlines of a DXF as a drawing, its dimensions and crossings.
#pragma once

#include <string>

#include "csg/solid/imported.h"

namespace whittle {

// LINE ARC CIRCLE ELLIPSE LWPOLYLINE POLYLINE (with bulges) and INSERT; lines and arcs whose ends are nearer than 1/1024 are one contour, and all contours are
// one figure. Open ones are closed by a line. Coordinates are (p - origin) * scale. kWorld fault where the text is no DXF.
Result<Drawing> read_dxf(const std::string& text, const DrawingRequest& request);

// kScene fault, in OpenSCAD's words, where there is none or it has a type without a value.
Result<double> read_dxf_dimension(const std::string& text, const std::string& file, const DrawingRequest& request, const std::string& name);
// Of the first two lines of the layer that stand alone.
Result<Vec2> read_dxf_crossing(const std::string& text, const std::string& file, const DrawingRequest& request);

}  // namespace whittle
