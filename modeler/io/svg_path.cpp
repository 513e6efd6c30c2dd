#include "modeler/io/svg_path.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace whittle {
namespace {

constexpr double kPi = 3.14159265358979323846;

class Scan {
public:
    explicit Scan(std::string_view text) : text_(text) {}
    bool end() { return skip(), at_ == text_.size(); }
    char peek() { return skip(), at_ < text_.size() ? text_[at_] : '\0'; }
    char take() { return text_[at_++]; }
    std::string_view rest() const { return text_.substr(at_); }
    bool number(double& out) {
        skip();
        const bool plus = at_ < text_.size() && text_[at_] == '+';
        const char* from = text_.data() + at_ + (plus ? 1 : 0);
        const auto [end, error] = std::from_chars(from, text_.data() + text_.size(), out);
        if (error != std::errc() || !std::isfinite(out)) return false;
        at_ = static_cast<std::size_t>(end - text_.data());
        return true;
    }
    // The flags of an arc may stand without a space: "a1 1 0 01.5.5".
    bool flag(bool& out) {
        const char c = peek();
        if (c != '0' && c != '1') return false;
        out = take() == '1';
        return true;
    }
    bool point(Vec2& out) { return number(out.x) && number(out.y); }
    std::string_view word() {
        skip();
        const std::size_t start = at_;
        while (at_ < text_.size() && (std::isalpha(static_cast<unsigned char>(text_[at_])) || text_[at_] == '%')) ++at_;
        return text_.substr(start, at_ - start);
    }

private:
    void skip() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == ',' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r')) ++at_;
    }
    std::string_view text_;
    std::size_t at_ = 0;
};

// An elliptical arc by its ends, as appendix F.6 turns it into centre and angles.
struct Arc { Vec2 radii; double tilt_deg; bool large, sweep; Vec2 end; };

class PathReader {
public:
    PathReader(OutlineBuilder& builder, const PlaneMap& map, std::string_view data) : builder_(builder), map_(map), scan_(data) {}

    bool run() {
        char command = '\0';
        while (!scan_.end()) {
            const char c = scan_.peek();
            if (std::isalpha(static_cast<unsigned char>(c))) command = scan_.take();
            else if (command == '\0' || command == 'Z' || command == 'z') return false;
            if (!started_ && command != 'M' && command != 'm') return false;
            if (!step(command)) return false;
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        return true;
    }

private:
    bool step(char command) {
        relative_ = std::islower(static_cast<unsigned char>(command)) != 0;
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
        const Vec2 control = handle_;
        const char before = std::exchange(last_, kind);
        if (kind != 'Z' && kind != 'M') reopen();
        switch (kind) {
            case 'M': return move();
            case 'Z': return close();
            case 'L': return line();
            case 'H': return upright(0);
            case 'V': return upright(1);
            case 'C': return cubic({});
            case 'S': return cubic(before == 'C' || before == 'S' ? 2.0 * at_ - control : at_);
            case 'Q': return quadratic({});
            case 'T': return quadratic(before == 'Q' || before == 'T' ? 2.0 * at_ - control : at_);
            case 'A': return arc();
            default: return false;
        }
    }

    bool point(Vec2& p) {
        if (!scan_.point(p)) return false;
        if (relative_) p += at_;
        return true;
    }
    // After a Z the next command starts again where that contour started.
    void reopen() {
        if (closed_) builder_.move_to(map_, at_);
        closed_ = false;
    }
    bool move() {
        Vec2 p;
        if (!point(p)) return false;
        builder_.move_to(map_, p);
        start_ = at_ = p;
        started_ = true;
        closed_ = false;
        return true;
    }
    bool close() {
        builder_.close();
        at_ = start_;
        closed_ = true;
        return true;
    }
    bool line() {
        Vec2 p;
        if (!point(p)) return false;
        builder_.line_to(map_, at_ = p);
        return true;
    }
    bool upright(int axis) {
        double x = 0;
        if (!scan_.number(x)) return false;
        at_[axis] = relative_ ? at_[axis] + x : x;
        builder_.line_to(map_, at_);
        return true;
    }
    bool cubic(std::optional<Vec2> first) {
        Vec2 a = first.value_or(at_), b, p;
        if (!first && !point(a)) return false;
        if (!point(b) || !point(p)) return false;
        builder_.cubic_to(map_, a, b, p);
        handle_ = b;
        at_ = p;
        return true;
    }
    bool quadratic(std::optional<Vec2> control) {
        Vec2 a = control.value_or(at_), p;
        if (!control && !point(a)) return false;
        if (!point(p)) return false;
        builder_.quadratic_to(map_, a, p);
        handle_ = a;
        at_ = p;
        return true;
    }
    bool arc() {
        Arc arc{};
        if (!scan_.point(arc.radii) || !scan_.number(arc.tilt_deg) || !scan_.flag(arc.large) || !scan_.flag(arc.sweep) || !point(arc.end)) return false;
        add(arc);
        at_ = arc.end;
        return true;
    }

    void add(const Arc& arc) {
        Vec2 r = glm::abs(arc.radii);
        if (arc.end == at_) return;
        if (r.x == 0 || r.y == 0) return builder_.line_to(map_, arc.end);
        const double tilt = arc.tilt_deg * kPi / 180, cs = std::cos(tilt), sn = std::sin(tilt);
        const Vec2 half = (at_ - arc.end) / 2.0, turned{cs * half.x + sn * half.y, -sn * half.x + cs * half.y};
        const Vec2 share = turned / r;
        const double reach = glm::dot(share, share);
        if (reach > 1) r *= std::sqrt(reach);
        const Vec2 unit = turned / r;
        const double away = std::sqrt(std::max(0.0, 1 / glm::dot(unit, unit) - 1)) * (arc.large == arc.sweep ? -1 : 1);
        const Vec2 centre_unit{away * unit.y, -away * unit.x};
        const Vec2 c = centre_unit * r, middle = (at_ + arc.end) / 2.0;
        const Vec2 centre{cs * c.x - sn * c.y + middle.x, sn * c.x + cs * c.y + middle.y};
        const Vec2 from = unit - centre_unit, to = -unit - centre_unit;
        const double start = std::atan2(from.y, from.x);
        double sweep = std::atan2(to.y, to.x) - start;
        if (arc.sweep && sweep < 0) sweep += 2 * kPi;
        if (!arc.sweep && sweep > 0) sweep -= 2 * kPi;
        builder_.arc(map_, centre, Vec2(cs, sn) * r.x, Vec2(-sn, cs) * r.y, start, sweep, arc.end);
    }

    OutlineBuilder& builder_;
    const PlaneMap& map_;
    Scan scan_;
    Vec2 at_{0}, start_{0}, handle_{0};
    char last_ = '\0';
    bool relative_ = false, started_ = false, closed_ = false;
};

std::optional<PlaneMap> one_transform(std::string_view name, const std::vector<double>& v) {
    const std::size_t n = v.size();
    if (name == "matrix" && n == 6) return PlaneMap{v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate" && (n == 1 || n == 2)) return PlaneMap{1, 0, 0, 1, v[0], n == 2 ? v[1] : 0};
    if (name == "scale" && (n == 1 || n == 2)) return PlaneMap{v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
    if (name == "skewX" && n == 1) return PlaneMap{1, 0, std::tan(v[0] * kPi / 180), 1, 0, 0};
    if (name == "skewY" && n == 1) return PlaneMap{1, std::tan(v[0] * kPi / 180), 0, 1, 0, 0};
    if (name == "rotate" && (n == 1 || n == 3)) {
        const double c = std::cos(v[0] * kPi / 180), s = std::sin(v[0] * kPi / 180);
        const Vec2 p = n == 3 ? Vec2(v[1], v[2]) : Vec2(0);
        return PlaneMap{c, s, -s, c, p.x - c * p.x + s * p.y, p.y - s * p.x - c * p.y};
    }
    return std::nullopt;
}

}  // namespace

bool add_path(OutlineBuilder& builder, const PlaneMap& map, std::string_view data) { return PathReader(builder, map, data).run(); }

std::vector<double> read_numbers(std::string_view text) {
    Scan scan(text);
    std::vector<double> out;
    for (double x = 0; !scan.end() && scan.number(x);) out.push_back(x);
    return out;
}

PlaneMap read_transform(std::string_view text) {
    PlaneMap map;
    Scan scan(text);
    while (!scan.end()) {
        const std::string_view name = scan.word();
        if (name.empty() || scan.peek() != '(') break;
        const std::size_t end = scan.rest().find(')');
        if (end == std::string_view::npos) break;
        const auto one = one_transform(name, read_numbers(scan.rest().substr(1, end - 1)));
        if (!one) break;
        map = map * *one;
        scan = Scan(scan.rest().substr(end + 1));
    }
    return map;
}

bool read_length(std::string_view text, SvgLength& out) {
    Scan scan(text);
    if (!scan.number(out.number)) return false;
    out.unit = scan.word();
    return true;
}

}  // namespace whittle
