// flat_files.h — 2D sets as files: SVG (arcs as arcs), DXF (LINE, ARC, CIRCLE, ELLIPSE), PDF (arcs as cubic curves, no further off than 3e-4 of their radius).
//
// Lengths in millimetres, numbers the shortest that read back to the same double; no date and no name of the machine: the same set, the same bytes.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/flat_outline.h"

namespace whittle {

// Requires: at least one outline.
std::string svg_text(const std::vector<Outline>& outlines);
std::string dxf_text(const std::vector<Outline>& outlines);
std::string pdf_text(const std::vector<Outline>& outlines);

}  // namespace whittle
