// builtin_metrics.cpp — textmetrics() and fontmetrics() (of later versions): measures of what text() would draw.
#include <cmath>

#include <fmt/format.h>

#include "csg/eval/builtin_function_parts.h"
#include "csg/eval/machine.h"
#include "csg/eval/record_builder.h"

namespace whittle {
namespace {

void complain_of_type(FunctionCall& call, std::string_view parameter, const Value& value, Type wanted) {
    call.machine.warn(call.place,
                      fmt::format("{}(..., {}={}) Invalid type: expected {}, found {}", call.name, parameter, call.machine.text_of(value), type_name(wanted), type_name(value.type())),
                      signature_hint(call.name));
}

std::string text_or(FunctionCall& call, std::size_t which, std::string_view parameter, std::string otherwise) {
    if (call[which].is_string()) return std::string(call[which].string());
    if (!call[which].is_undef()) complain_of_type(call, parameter, call[which], Type::kString);
    return otherwise;
}

double number_or(FunctionCall& call, std::size_t which, std::string_view parameter, double otherwise) {
    if (call[which].is_number() && std::isfinite(call[which].number())) return call[which].number();
    if (!call[which].is_undef()) complain_of_type(call, parameter, call[which], Type::kNumber);
    return otherwise;
}

Value pair(Heap& heap, Vec2 v) {
    const double numbers[2] = {v.x, v.y};
    return heap.numbers(numbers, 2);
}

}  // namespace

void tell_complaints(FunctionCall& call, const Value& complaints) {
    if (!complaints.is_string()) return;
    std::string_view rest = complaints.string();
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        call.machine.warn(call.place, std::string(rest.substr(0, end)), signature_hint(call.name));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
}

Value function_textmetrics(FunctionCall& call) {
    // text size font | direction language script halign valign spacing, complaints
    tell_complaints(call, call[9]);
    TextRequest r;
    r.text = text_or(call, 0, "text", "");
    r.size = number_or(call, 1, "size", r.size);
    r.font = text_or(call, 2, "font", "");
    r.direction = text_or(call, 3, "direction", "");
    r.language = text_or(call, 4, "language", r.language);
    r.script = text_or(call, 5, "script", "");
    r.halign = text_or(call, 6, "halign", r.halign);
    r.valign = text_or(call, 7, "valign", r.valign);
    r.spacing = number_or(call, 8, "spacing", r.spacing);
    const auto text = call.machine.fonts().text(r, GlyphGrid::kOpenScad);
    if (!text) {
        call.machine.warn(call.place, "textmetrics() cannot be measured", text.error().message);
        return {};
    }
    for (const std::string& warning : text->warnings) call.machine.warn(call.place, warning);
    if (text->substituted) call.machine.warn(call.place, fmt::format("Font '{}' is not installed, '{}' stands in for it", r.font, text->font));
    Heap& heap = call.machine.heap();
    RecordBuilder out(heap);
    out.set("position", pair(heap, text->metrics.position));
    out.set("size", pair(heap, text->metrics.size));
    out.set("ascent", Value(text->metrics.ascent));
    out.set("descent", Value(text->metrics.descent));
    out.set("offset", pair(heap, text->metrics.offset));
    out.set("advance", pair(heap, text->metrics.advance));
    return out.finish();
}

Value function_fontmetrics(FunctionCall& call) {
    // size font, complaints
    tell_complaints(call, call[2]);
    const double size = number_or(call, 0, "size", TextRequest{}.size);
    const auto font = call.machine.fonts().font_metrics(text_or(call, 1, "font", ""), size);
    if (!font) {
        call.machine.warn(call.place, "fontmetrics() cannot be measured", font.error().message);
        return {};
    }
    Heap& heap = call.machine.heap();
    const auto span = [&heap](double ascent, double descent) {
        RecordBuilder made(heap);
        made.set("ascent", Value(ascent));
        made.set("descent", Value(descent));
        return made.finish();
    };
    RecordBuilder face(heap), out(heap);
    face.set("family", heap.string(font->family));
    face.set("style", heap.string(font->style));
    out.set("nominal", span(font->nominal_ascent, font->nominal_descent));
    out.set("max", span(font->max_ascent, font->max_descent));
    out.set("interline", Value(font->interline));
    out.set("font", face.finish());
    return out.finish();
}

}  // namespace whittle
