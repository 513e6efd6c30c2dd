// scene_text.h — texts as solids, and a dozen scenes that between them hold every kind of shape.
#pragma once

#include <string>
#include <vector>

#include "csg/solid/solid.h"

namespace whittle::stress {

// Requires: the text is a program that needs no file.
Solid solid_of(const std::string& text);

struct TextScene {
    const char* name;
    const char* text;              // about the origin, some 10 across
    const char* definitions = "";  // of modules, before it
};
const std::vector<TextScene>& text_scenes();

// A number as text that reads as the same double.
std::string literal(double x);

}  // namespace whittle::stress
