// span_text.cpp — see span_text.h.
#include "modeler/cli/span_text.h"

#include <fmt/compile.h>

namespace whittle {

namespace {

// As written, 0..1; null where no colour was named.
std::string color_member(const Material& material) {
    json::Buffer out;
    json::raw(out, R"("color":)");
    if (material.color && material.color->x >= 0 && material.color->y >= 0 && material.color->z >= 0)
        json::triple(out, Vec3(*material.color));
    else
        json::raw(out, "null");
    return fmt::to_string(out);
}

// For people: -0 reads as a number that was rounded.
Vec3 without_sign_of_zero(const Vec3& v) { return v + Vec3(0.0); }

// {"t":..,"t_error":..,"point":..,"normal":.. , open still.
void append_place_json(json::Buffer& out, const Ray& ray, const End& end) {
    json::raw(out, R"({"t":)");
    json::number(out, end.t);
    json::raw(out, R"(,"t_error":)");
    json::number(out, end.t_error);
    json::raw(out, R"(,"point":)");
    json::triple(out, point_at(ray, end.t));
    json::raw(out, R"(,"normal":)");
    json::triple(out, end.normal);
}

void append_end_json(json::Buffer& out, const Ray& ray, const End& end, const UseTexts& uses) {
    append_place_json(out, ray, end);
    out.push_back(',');
    json::raw(out, uses.color(end.use));
    fmt::format_to(fmt::appender(out), FMT_COMPILE(R"(,"surface":{},)"), end.surface);
    json::raw(out, uses.place(end.use));
    json::raw(out, end.certified ? R"(,"certified":true})" : R"(,"certified":false})");
}

void append_interface_json(json::Buffer& out, const Ray& ray, const Interface& interface, const UseTexts& uses) {
    append_place_json(out, ray, interface.at);
    fmt::format_to(fmt::appender(out), FMT_COMPILE(R"(,"surface":{},"from":{{{},{}}},"to":{{{},{}}},"certified":{}}})"), interface.at.surface,
                   uses.color(interface.from), uses.place(interface.from), uses.color(interface.at.use), uses.place(interface.at.use), interface.at.certified);
}

void append_interface_row(json::Buffer& out, const Ray& ray, const Interface& interface, const UseTexts& uses) {
    const Vec3 p = without_sign_of_zero(point_at(ray, interface.at.t));
    fmt::format_to(fmt::appender(out), "  turn t {:<22} at ({}, {}, {})  matter of {} to {}{}\n", interface.at.t, p.x, p.y, p.z, uses.short_place(interface.from),
                   uses.short_place(interface.at.use), interface.at.certified ? "" : "  (not certified)");
}

void append_end_row(json::Buffer& out, const char* way, const Ray& ray, const End& end, const UseTexts& uses) {
    const Vec3 p = without_sign_of_zero(point_at(ray, end.t)), n = without_sign_of_zero(end.normal);
    fmt::format_to(fmt::appender(out), "  {:<4}t {:<22} at ({}, {}, {})  normal ({:.6g}, {:.6g}, {:.6g})  solid {}  surface {}  {}{}\n", way, end.t, p.x, p.y, p.z,
                   n.x, n.y, n.z, end.use, end.surface, uses.short_place(end.use), end.certified ? "" : "  (not certified)");
}

}  // namespace

UseTexts::UseTexts(const std::vector<LeafUse>& uses, const SourceTable& sources) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const SourcePlace& place = uses[i].place;
        const bool placed = place.line != 0 && place.file < sources.files.size();
        const std::string name = placed ? sources.files[place.file].name : std::string();
        json::Buffer out;
        fmt::format_to(fmt::appender(out), R"("solid":{},"file":)", i);
        if (placed)
            json::string(out, name);
        else
            json::raw(out, "null");
        fmt::format_to(fmt::appender(out), R"(,"line":{})", placed ? place.line : 0);
        places_.push_back(fmt::to_string(out));
        colors_.push_back(color_member(uses[i].material));
        short_.push_back(placed ? fmt::format("{}:{}", name, place.line) : std::string("(no place in the text)"));
    }
}

void append_spans_json(json::Buffer& out, const Ray& ray, const Spans& spans, const Interfaces& interfaces, const UseTexts& uses) {
    json::raw(out, R"({"spans":[)");
    const char* before = R"({"in":)";
    for (const Span& span : spans) {
        json::raw(out, before);
        if (span.in) append_end_json(out, ray, *span.in, uses);
        else json::raw(out, "null");
        json::raw(out, R"(,"out":)");
        if (span.out) append_end_json(out, ray, *span.out, uses);
        else json::raw(out, "null");
        out.push_back('}');
        before = R"(,{"in":)";
    }
    json::raw(out, R"(],"interfaces":[)");
    for (const Interface& interface : interfaces) {
        if (&interface != &interfaces.front()) out.push_back(',');
        append_interface_json(out, ray, interface, uses);
    }
    json::raw(out, "]}\n");
}

void append_spans_table(json::Buffer& out, const Ray& ray, const Spans& spans, const Interfaces& interfaces, const UseTexts& uses) {
    const Vec3 o = ray.origin, d = ray.direction;
    fmt::format_to(fmt::appender(out), "ray from ({}, {}, {}) along ({}, {}, {}):{}\n", o.x, o.y, o.z, d.x, d.y, d.z, spans.empty() ? " nothing" : "");
    auto interface = interfaces.begin();
    for (const Span& span : spans) {
        if (span.in) append_end_row(out, "in", ray, *span.in, uses);
        else json::raw(out, "  in  before the ray's origin\n");
        for (; interface != interfaces.end() && (!span.out || interface->at.t <= span.out->t); ++interface) append_interface_row(out, ray, *interface, uses);
        if (span.out) append_end_row(out, "out", ray, *span.out, uses);
        else json::raw(out, "  out never\n");
    }
}

}  // namespace whittle
