// flat_files.cpp — see flat_files.h.
// Source: W3C, SVG 1.1, chapter 8; Autodesk, DXF Reference, ENTITIES; ISO 32000-1 (PDF), 8.5.
#include "modeler/export/flat_files.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "modeler/export/number_text.h"

namespace whittle {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180;

// The half axes of an ellipse and the angle of the larger; from any pair of conjugate ones.
struct Axes { double major, minor, tilt; };
Axes axes_of(const OutlineSide& s) {
    if (s.round()) return {glm::length(s.u), glm::length(s.u), 0};
    const double xx = s.u.x * s.u.x + s.v.x * s.v.x, xy = s.u.x * s.u.y + s.v.x * s.v.y, yy = s.u.y * s.u.y + s.v.y * s.v.y;
    const double tilt = std::atan2(2 * xy, xx - yy) / 2, mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
    const double major = std::sqrt(mean + half);
    return {major, std::fabs(s.u.x * s.v.y - s.u.y * s.v.x) / major, tilt};
}

Vec2 point_of(const OutlineSide& s, double t) { return s.centre + s.u * std::cos(t) + s.v * std::sin(t); }

// Angles are sums of a few arc tangents and turns, each within some units of roundoff of 2 pi: well under this. So a full turn is known as one, and whole
// parts are not counted one too many.
constexpr double kTurnRounding = 0x1p-40;

// SVG's arcs have no full turn, and near half of one their centre is in doubt: at most a third.
std::string svg_arc(const OutlineSide& s) {
    const Axes axes = axes_of(s);
    const int n = std::max(1, static_cast<int>(std::ceil(std::fabs(s.turn()) / (2 * kPi / 3) - kTurnRounding)));
    std::string out;
    for (int i = 1; i <= n; ++i) {
        const Vec2 to = i == n ? s.end : point_of(s, s.from + (s.to - s.from) * i / n);
        out += fmt::format(" A {} {} {} 0 {} {} {}", shortest(axes.major), shortest(axes.minor), shortest(-axes.tilt / kDegree), s.turn() > 0 ? 0 : 1, shortest(to.x), shortest(-to.y));
    }
    return out;
}

// The angle, in degrees within [0, 360), at which p stands from c.
double angle_deg(Vec2 c, Vec2 p) {
    const double a = std::atan2(p.y - c.y, p.x - c.x) / kDegree;
    return a < 0 ? a + 360 : a;
}

class Dxf {
public:
    void group(int code, const std::string& value) { text_ += fmt::format("{:>3}\n{}\n", code, value); }
    void point(int code, Vec2 p) {
        group(code, shortest(p.x));
        group(code + 10, shortest(p.y));
        group(code + 20, "0");
    }
    void entity(const char* type) {
        group(0, type);
        group(8, "0");
    }
    void line(Vec2 a, Vec2 b) {
        entity("LINE");
        point(10, a);
        point(11, b);
    }
    void arc(Vec2 from, const OutlineSide& s) {
        const bool full = std::fabs(s.turn()) >= 2 * kPi - kTurnRounding;
        if (!s.round()) return ellipse(s, full);
        entity(full ? "CIRCLE" : "ARC");
        point(10, s.centre);
        group(40, shortest(glm::length(s.u)));
        if (full) return;
        // Counter-clockwise always.
        group(50, shortest(angle_deg(s.centre, s.turn() > 0 ? from : s.end)));
        group(51, shortest(angle_deg(s.centre, s.turn() > 0 ? s.end : from)));
    }
    // Degree 2, clamped at both ends: the Bezier curve. In a plane (8).
    void spline(Vec2 from, const OutlineSide& s) {
        entity("SPLINE");
        group(70, "8");
        group(71, "2");
        group(72, "6");
        group(73, "3");
        group(74, "0");
        for (const char* knot : {"0", "0", "0", "1", "1", "1"}) group(40, knot);
        for (const Vec2& p : {from, s.control, s.end}) point(10, p);
    }
    std::string take() { return std::move(text_); }

private:
    void ellipse(const OutlineSide& s, bool full) {
        const Axes axes = axes_of(s);
        const Vec2 major{axes.major * std::cos(axes.tilt), axes.major * std::sin(axes.tilt)}, minor = Vec2(-major.y, major.x) * (axes.minor / axes.major);
        entity("ELLIPSE");
        point(10, s.centre);
        point(11, major);
        group(40, shortest(axes.minor / axes.major));
        const auto parameter = [&](double t) {
            const Vec2 d = point_of(s, t) - s.centre;
            const double a = std::atan2(glm::dot(d, minor) / glm::dot(minor, minor), glm::dot(d, major) / glm::dot(major, major));
            return a < 0 ? a + 2 * kPi : a;
        };
        double from = full ? 0 : parameter(s.turn() > 0 ? s.from : s.to), to = full ? 2 * kPi : parameter(s.turn() > 0 ? s.to : s.from);
        if (to <= from) to += 2 * kPi;
        group(41, shortest(from));
        group(42, shortest(to));
    }
    std::string text_;
};

std::string pdf_curves(const OutlineSide& s, double mm, Vec2 lo) {
    const int n = std::max(1, static_cast<int>(std::ceil(std::fabs(s.to - s.from) / (kPi / 2) - kTurnRounding)));
    const double step = (s.to - s.from) / n, reach = 4.0 / 3 * std::tan(step / 4);
    std::string out;
    const auto place = [&](Vec2 p) { return shortest((p.x - lo.x) * mm) + " " + shortest((p.y - lo.y) * mm); };
    for (int i = 1; i <= n; ++i) {
        const double t0 = s.from + step * (i - 1), t1 = s.from + step * i;
        const auto along = [&](double t) { return s.v * std::cos(t) - s.u * std::sin(t); };
        const Vec2 end = i == n ? s.end : point_of(s, t1);
        out += place(point_of(s, t0) + along(t0) * reach) + " " + place(end - along(t1) * reach) + " " + place(end) + " c\n";
    }
    return out;
}

}  // namespace

std::string svg_text(const std::vector<Outline>& outlines) {
    const OutlineBox box = box_of(outlines);
    const Vec2 size = box.hi - box.lo;
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out += fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n", shortest(size.x), shortest(size.y));
    out += fmt::format("<path transform=\"translate({} {})\" d=\"", shortest(-box.lo.x), shortest(box.hi.y));
    for (const Outline& o : outlines) {
        out += fmt::format("M {} {}", shortest(o.start.x), shortest(-o.start.y));
        for (const OutlineSide& s : o.sides) {
            if (s.curved) out += svg_arc(s);
            else if (s.quadratic) out += fmt::format(" Q {} {} {} {}", shortest(s.control.x), shortest(-s.control.y), shortest(s.end.x), shortest(-s.end.y));
            else if (&s != &o.sides.back()) out += fmt::format(" L {} {}", shortest(s.end.x), shortest(-s.end.y));
        }
        out += " Z\n";
    }
    return out + "\" fill=\"lightgray\" fill-rule=\"evenodd\" stroke=\"none\"/>\n</svg>\n";
}

std::string dxf_text(const std::vector<Outline>& outlines) {
    Dxf out;
    out.group(0, "SECTION");
    out.group(2, "ENTITIES");
    for (const Outline& o : outlines) {
        Vec2 at = o.start;
        for (const OutlineSide& s : o.sides) {
            if (s.curved) out.arc(at, s);
            else if (s.quadratic) out.spline(at, s);
            else out.line(at, s.end);
            at = s.end;
        }
    }
    out.group(0, "ENDSEC");
    out.group(0, "EOF");
    return out.take();
}

std::string pdf_text(const std::vector<Outline>& outlines) {
    const OutlineBox box = box_of(outlines);
    constexpr double kPointsPerMm = 72 / 25.4;
    const auto place = [&](Vec2 p) { return shortest((p.x - box.lo.x) * kPointsPerMm) + " " + shortest((p.y - box.lo.y) * kPointsPerMm); };
    std::string path = "0.8 g\n";
    for (const Outline& o : outlines) {
        path += place(o.start) + " m\n";
        Vec2 at = o.start;
        for (const OutlineSide& s : o.sides) {
            if (s.curved) path += pdf_curves(s, kPointsPerMm, box.lo);
            else if (s.quadratic) path += place((at + 2.0 * s.control) / 3.0) + " " + place((s.end + 2.0 * s.control) / 3.0) + " " + place(s.end) + " c\n";
            else path += place(s.end) + " l\n";
            at = s.end;
        }
        path += "h\n";
    }
    path += "f*\n";
    const Vec2 size = (box.hi - box.lo) * kPointsPerMm;
    const std::vector<std::string> objects{"<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
                                           fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Contents 4 0 R /Resources << >> >>", shortest(size.x), shortest(size.y)),
                                           fmt::format("<< /Length {} >>\nstream\n{}endstream", path.size(), path)};
    std::string out = "%PDF-1.4\n", table = fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        table += fmt::format("{:010} 00000 n \n", out.size());
        out += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
    }
    const std::size_t start = out.size();
    return out + table + fmt::format("trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{}\n%%EOF\n", objects.size() + 1, start);
}

}  // namespace whittle
