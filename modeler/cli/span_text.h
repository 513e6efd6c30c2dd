// span_text.h — spans as text: JSON for programs, a small table for people.
#pragma once

#include <string>
#include <vector>

#include "csg/lang/source.h"
#include "csg/span/ray.h"
#include "modeler/cli/json.h"
#include "tracer/engine/interfaces.h"

namespace whittle {

// What every end on one leaf use says alike, made once: its colour, number, file and line, as JSON members.
class UseTexts {
public:
    UseTexts(const std::vector<LeafUse>& uses, const SourceTable& sources);
    // `"color":[1,0,0]`, and `"solid":3,"file":"a.scad","line":7`.
    const std::string& color(std::uint32_t use) const { return colors_[use]; }
    const std::string& place(std::uint32_t use) const { return places_[use]; }
    // "a.scad:7"
    const std::string& short_place(std::uint32_t use) const { return short_[use]; }

private:
    std::vector<std::string> colors_, places_, short_;
};

// {"spans":[...],"interfaces":[...]} and a newline.
void append_spans_json(json::Buffer& out, const Ray& ray, const Spans& spans, const Interfaces& interfaces, const UseTexts& uses);
// A line an end and an interface, in the order the ray meets them; "nothing" where there is none.
void append_spans_table(json::Buffer& out, const Ray& ray, const Spans& spans, const Interfaces& interfaces, const UseTexts& uses);

}  // namespace whittle
