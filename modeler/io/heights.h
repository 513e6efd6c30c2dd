// heights.h — height maps for surface(): numbers in a text, or the brightness of a picture.
#pragma once

#include <string>

#include "csg/solid/imported.h"
#include "tracer/image/image_file.h"

namespace whittle {

// A line of numbers a row, y growing by line; '#' starts a comment. Shorter rows are filled with 0. kWorld fault at what is no number.
Result<HeightMap> read_heights(const std::string& text);

// 100 for white, 0 for black, by the brightness of linear Rec. 709 weights; the top row has the largest y. `invert` as OpenSCAD does it.
HeightMap heights_of_picture(const Image& image, bool invert);

}  // namespace whittle
