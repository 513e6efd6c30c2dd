#include "modeler/io/svg.h"

#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "modeler/io/svg_path.h"
#include "modeler/io/svg_stroke.h"

namespace whittle {
namespace {

using pugi::xml_node;

constexpr int kDeepestGroup = 256;

const char* local(const char* name) {
    const char* colon = std::strchr(name, ':');
    return colon ? colon + 1 : name;
}

class SvgReader {
public:
    explicit SvgReader(const DrawingRequest& request) : request_(request) {}

    Result<Drawing> read(const xml_node& svg) {
        const PlaneMap sheet = sheet_of(svg);
        children(svg, sheet, 0, request_.layer.empty());
        if (others_ > 0) drawing_.remarks.push_back(fmt::format("{} elements that are not drawn (text, images ...) passed over", others_));
        if (broken_ > 0) drawing_.remarks.push_back(fmt::format("{} paths end in an error, drawn up to there", broken_));
        if (request_.center) centre();
        return std::move(drawing_);
    }

private:
    double mm_of(const SvgLength& length, double of_percent) const {
        const double inch = 25.4;
        if (length.unit == "mm") return length.number;
        if (length.unit == "cm") return length.number * 10;
        if (length.unit == "in") return length.number * inch;
        if (length.unit == "pt") return length.number * inch / 72;
        if (length.unit == "pc") return length.number * inch / 6;
        if (length.unit == "%") return of_percent * length.number / 100;
        return length.number * inch / request_.dpi;
    }

    // User units to millimetres, y up from the sheet's lower edge. As in OpenSCAD a unit is a millimetre where there is no viewBox, and a viewBox's
    // own lower end moves the drawing the other way.
    PlaneMap sheet_of(const xml_node& svg) const {
        const auto box = read_numbers(svg.attribute("viewBox").as_string());
        const bool has_box = box.size() == 4 && box[2] > 0 && box[3] > 0;
        const double px = 25.4 / request_.dpi;
        const auto side = [&](const char* name, double of_box) {
            SvgLength length{100, "%"};
            read_length(svg.attribute(name).as_string(), length);
            return mm_of(length, of_box * px);
        };
        const double width = side("width", has_box ? box[2] : 0), height = side("height", has_box ? box[3] : 0);
        if (!has_box) return {1, 0, 0, -1, 0, height};
        double sx = width / box[2], sy = height / box[3], dx = 0, dy = 0;
        if (std::string_view(svg.attribute("preserveAspectRatio").as_string()).substr(0, 4) != "none") {
            const double s = std::min(sx, sy);
            dx = (width - s * box[2]) / 2;
            dy = (height - s * box[3]) / 2;
            sx = sy = s;
        }
        return {sx, 0, 0, -sy, dx - sx * box[0], height - dy - sy * box[1]};
    }

    static bool is_hidden(const xml_node& node) {
        return std::strcmp(node.attribute("display").as_string(), "none") == 0 || std::strstr(node.attribute("style").as_string(), "display:none") != nullptr;
    }

    void children(const xml_node& parent, const PlaneMap& map, int depth, bool wanted) {
        if (depth > kDeepestGroup) {
            ++others_;
            return;
        }
        for (const xml_node& node : parent.children()) {
            if (node.type() != pugi::node_element || is_hidden(node)) continue;
            const std::string name = local(node.name());
            const bool asked = wanted || request_.layer == node.attribute("id").as_string() || request_.layer == node.attribute("inkscape:label").as_string();
            const PlaneMap inner = map * read_transform(node.attribute("transform").as_string());
            if (name == "g" || name == "a" || name == "svg") children(node, inner, depth + 1, asked);
            else if (asked) element(node, name, inner);
        }
    }

    void element(const xml_node& node, const std::string& name, const PlaneMap& map) {
        OutlineBuilder builder;
        if (name == "path") return path(node, map);
        if (name == "line" || name == "polyline") return line(node, name, map);
        if (name == "polygon") {
            add_points(builder, map, read_numbers(node.attribute("points").as_string()));
        } else if (name == "rect") {
            rectangle(builder, node, map);
        } else if (name == "circle" || name == "ellipse") {
            const Vec2 c{length(node, "cx"), length(node, "cy")};
            const double rx = length(node, name == "circle" ? "r" : "rx"), ry = length(node, name == "circle" ? "r" : "ry");
            if (rx > 0 && ry > 0) add_ellipse(builder, map, c, {rx, 0}, {0, ry});
        } else {
            if (name == "text" || name == "image" || name == "use" || name == "switch") ++others_;
            return;
        }
        add_figure({builder.take()});
    }

    void add_figure(DrawnFigure&& figure) {
        if (!figure.contours.empty()) drawing_.figures.push_back(std::move(figure));
    }

    void add_stroke(const xml_node& node, const DrawnContour& line, const PlaneMap& map) {
        for (DrawnFigure& piece : stroked(line, pen_of(node), map)) add_figure(std::move(piece));
    }

    static void add_points(OutlineBuilder& builder, const PlaneMap& map, const std::vector<double>& n) {
        for (std::size_t i = 0; i + 1 < n.size(); i += 2) i == 0 ? builder.move_to(map, {n[0], n[1]}) : builder.line_to(map, {n[i], n[i + 1]});
    }

    // As in OpenSCAD what the path closes is filled, and what it leaves open is as wide as its stroke.
    void path(const xml_node& node, const PlaneMap& map) {
        const char* data = node.attribute("d").as_string();
        OutlineBuilder in_user_units, drawn;
        if (!add_path(in_user_units, {}, data)) ++broken_;
        add_path(drawn, map, data);
        const std::vector<bool> open = in_user_units.left_open();
        std::vector<DrawnContour> lines = in_user_units.take(), contours = drawn.take();
        DrawnFigure filled;
        for (std::size_t i = 0; i < contours.size(); ++i) {
            if (!open[i]) {
                filled.contours.push_back(std::move(contours[i]));
                continue;
            }
            lines[i].sides.pop_back();  // which would close it
            add_stroke(node, lines[i], map);
        }
        add_figure(std::move(filled));
    }

    // A stroke also where a polyline ends at its start.
    void line(const xml_node& node, const std::string& name, const PlaneMap& map) {
        OutlineBuilder builder;
        if (name == "line") add_points(builder, {}, {length(node, "x1"), length(node, "y1"), length(node, "x2"), length(node, "y2")});
        else add_points(builder, {}, read_numbers(node.attribute("points").as_string()));
        const std::vector<bool> open = builder.left_open();
        std::vector<DrawnContour> lines = builder.take();
        if (lines.empty()) return;
        if (open[0]) lines[0].sides.pop_back();
        add_stroke(node, lines[0], map);
    }

    // An attribute of its own, else what `style` says; empty where neither does.
    static std::string property(const xml_node& node, const char* name) {
        if (const auto attribute = node.attribute(name)) return attribute.as_string();
        const std::string_view style = node.attribute("style").as_string();
        for (std::size_t at = 0; at < style.size();) {
            const std::size_t end = std::min(style.find(';', at), style.size()), colon = style.find(':', at);
            std::string_view key = style.substr(at, std::min(colon, end) - at);
            key.remove_prefix(std::min(key.find_first_not_of(" \t\n"), key.size()));
            if (colon < end && key == name) return std::string(style.substr(colon + 1, end - colon - 1));
            at = end + 1;
        }
        return {};
    }

    // As OpenSCAD has it: a unit wide where no width is said or hardly one, square caps where none are said.
    Pen pen_of(const xml_node& node) const {
        constexpr double kThinnest = 0.01;
        Pen pen;
        const std::string said = property(node, "stroke-width");
        SvgLength width;  // its unit is a piece of what is said
        if (read_length(said, width)) pen.width = in_user_units(width);
        if (!(pen.width >= kThinnest && std::isfinite(pen.width))) pen.width = 1;
        const std::string cap = property(node, "stroke-linecap"), join = property(node, "stroke-linejoin");
        if (cap == "butt") pen.cap = LineCap::kButt;
        if (cap == "round") pen.cap = LineCap::kRound;
        if (join == "bevel") pen.join = LineJoin::kBevel;
        if (join == "round") pen.join = LineJoin::kRound;
        return pen;
    }

    double in_user_units(const SvgLength& length) const {
        return length.unit.empty() || length.unit == "px" || length.unit == "%" ? length.number : mm_of(length, 0) * request_.dpi / 25.4;
    }

    double length(const xml_node& node, const char* name) const {
        SvgLength out;
        if (!read_length(node.attribute(name).as_string(), out)) return 0;
        return in_user_units(out);
    }

    void rectangle(OutlineBuilder& builder, const xml_node& node, const PlaneMap& map) const {
        const double x = length(node, "x"), y = length(node, "y"), w = length(node, "width"), h = length(node, "height");
        if (!(w > 0 && h > 0)) return;
        const bool has_rx = !node.attribute("rx").empty(), has_ry = !node.attribute("ry").empty();
        const double rx = std::min(length(node, has_rx ? "rx" : "ry"), w / 2), ry = std::min(length(node, has_ry ? "ry" : "rx"), h / 2);
        if (!(rx > 0 && ry > 0)) {
            builder.move_to(map, {x, y});
            for (const Vec2& p : {Vec2(x + w, y), Vec2(x + w, y + h), Vec2(x, y + h)}) builder.line_to(map, p);
            return;
        }
        constexpr double kQuarter = 1.5707963267948966;
        builder.move_to(map, {x + w, y + ry});
        const Vec2 u{rx, 0}, v{0, ry};
        builder.line_to(map, {x + w, y + h - ry});
        builder.arc(map, {x + w - rx, y + h - ry}, u, v, 0, kQuarter, {x + w - rx, y + h});
        builder.line_to(map, {x + rx, y + h});
        builder.arc(map, {x + rx, y + h - ry}, u, v, kQuarter, kQuarter, {x, y + h - ry});
        builder.line_to(map, {x, y + ry});
        builder.arc(map, {x + rx, y + ry}, u, v, 2 * kQuarter, kQuarter, {x + rx, y});
        builder.line_to(map, {x + w - rx, y});
        builder.arc(map, {x + w - rx, y + ry}, u, v, 3 * kQuarter, kQuarter, {x + w, y + ry});
    }

    void centre() {
        Vec2 lo(HUGE_VAL), hi(-HUGE_VAL);
        for (const auto& figure : drawing_.figures)
            for (const auto& contour : figure.contours)
                for (const auto& side : contour.sides) lo = glm::min(lo, side.end()), hi = glm::max(hi, side.end());
        if (!(lo.x <= hi.x)) return;
        const Vec2 by = -(lo + hi) / 2.0;
        for (auto& figure : drawing_.figures)
            for (auto& contour : figure.contours) {
                contour.start += by;
                for (auto& side : contour.sides)
                    for (auto& p : side.p) p += by;
            }
    }

    const DrawingRequest& request_;
    Drawing drawing_;
    std::size_t others_ = 0, broken_ = 0;
};

}  // namespace

Result<Drawing> read_svg(const std::string& text, const DrawingRequest& request) {
    pugi::xml_document document;
    const auto read = document.load_buffer(text.data(), text.size());
    if (!read) return fail(Fault::kWorld, fmt::format("not a whole SVG: at byte {}: {}", read.offset, read.description()));
    for (const xml_node& node : document.children())
        if (std::strcmp(local(node.name()), "svg") == 0) return SvgReader(request).read(node);
    return fail(Fault::kWorld, "not an SVG: there is no <svg> in it");
}

}  // namespace whittle
