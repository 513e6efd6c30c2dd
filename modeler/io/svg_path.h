// svg_path.h — the small languages within SVG's attributes: path data, transforms, lengths, lists of numbers.
// Source: W3C, Scalable Vector Graphics 1.1, chapters 7 and 8 and appendix F.6.
#pragma once

#include <string_view>

#include "modeler/io/outline_builder.h"

namespace whittle {

// False where the data end in an error; what came before it is drawn, as the specification asks.
bool add_path(OutlineBuilder& builder, const PlaneMap& map, std::string_view data);

// translate scale rotate skewX skewY matrix; what is not understood ends the list.
PlaneMap read_transform(std::string_view text);

std::vector<double> read_numbers(std::string_view text);

// A number and what follows it: "mm", "px", "%", nothing ...
struct SvgLength { double number = 0; std::string_view unit; };
bool read_length(std::string_view text, SvgLength& out);

}  // namespace whittle
