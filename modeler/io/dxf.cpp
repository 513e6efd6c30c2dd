#include "modeler/io/dxf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "modeler/io/dxf_entities.h"
#include "modeler/io/outline_builder.h"

namespace whittle {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kJoin = 1.0 / 1024;  // OpenSCAD's grid for joining ends
constexpr int kDeepestInsert = 16;
constexpr std::size_t kMostInserted = 1'000'000;  // entities of blocks: a block of sixteen that are each inserted sixteen times is no drawing

// An open piece: a line, an arc or a polyline, joined to others at its ends.
struct Stroke {
    Vec2 start;
    std::vector<DrawnSide> sides;
    Vec2 end() const { return sides.back().end(); }
};

Stroke reversed(const Stroke& s) {
    Stroke out{s.end(), {}};
    for (std::size_t i = s.sides.size(); i-- > 0;) {
        const Vec2 to = i == 0 ? s.start : s.sides[i - 1].end();
        const DrawnSide& side = s.sides[i];
        if (side.degree == 3) out.sides.push_back({3, {side.p[1], side.p[0], to}, 0});
        else if (side.degree == 2) out.sides.push_back({2, {side.p[0], to, {}}, 0});
        else out.sides.push_back(DrawnSide::arc(to, -side.bulge));
    }
    return out;
}

class DxfReader {
public:
    DxfReader(const DxfFile& file, const DrawingRequest& request) : file_(file), request_(request) {}

    Result<void> gather() {
        const double s = request_.scale;
        entities(file_.entities, {s, 0, 0, s, -request_.origin.x * s, -request_.origin.y * s}, 0);
        if (inserted_ > kMostInserted) return fail(Fault::kWorld, fmt::format("its blocks stand for more than {} entities", kMostInserted));
        return {};
    }
    const std::vector<Stroke>& strokes() const { return strokes_; }

    Drawing drawing() {
        join();
        Drawing out;
        DrawnFigure figure{std::move(closed_)};
        if (open_ > 0) out.remarks.push_back(fmt::format("{} outlines are open (ends more than {} apart), closed by a line each", open_, kJoin));
        for (const auto& [type, count] : others_) out.remarks.push_back(fmt::format("{} entities {} passed over", count, type));
        if (!figure.contours.empty()) out.figures.push_back(std::move(figure));
        return out;
    }

private:
    bool wanted(const DxfEntity& e) const { return request_.layer.empty() || request_.layer == e.layer; }

    void entities(const std::vector<DxfEntity>& list, const PlaneMap& map, int depth) {
        for (const DxfEntity& e : list) {
            if (depth > 0 && ++inserted_ > kMostInserted) return;
            if (e.type == "INSERT") insert(e, map, depth);
            else if (wanted(e)) entity(e, map);
        }
    }

    void insert(const DxfEntity& e, const PlaneMap& map, int depth) {
        const auto block = file_.blocks.find(e.name);
        if (block == file_.blocks.end() || depth >= kDeepestInsert || !open_blocks_.insert(e.name).second) {  // a block in itself has no end
            ++others_["INSERT"];
            return;
        }
        const double sx = e.number(41, 1), sy = e.number(42, 1), a = e.number(50, 0) * kPi / 180;
        entities(block->second, map * PlaneMap{sx * std::cos(a), sx * std::sin(a), -sy * std::sin(a), sy * std::cos(a), e.at[0].x, e.at[0].y}, depth + 1);
        open_blocks_.erase(e.name);
    }

    void entity(const DxfEntity& e, const PlaneMap& map) {
        OutlineBuilder builder;
        if (e.type == "LINE") {
            if (e.at[0] == e.at[1]) return;
            strokes_.push_back({map.point(e.at[0]), {DrawnSide::line(map.point(e.at[1]))}});
        } else if (e.type == "CIRCLE") {
            const double r = e.number(40, 0);
            if (r > 0) add_ellipse(builder, map, e.at[0], {r, 0}, {0, r});
            take_closed(builder);
        } else if (e.type == "ARC") {
            const double r = e.number(40, 0);
            if (r > 0) ellipse_arc(map, e.at[0], {r, 0}, {0, r}, e.number(50, 0) * kPi / 180, e.number(51, 360) * kPi / 180);
        } else if (e.type == "ELLIPSE") {
            const Vec2 u = e.at[1], v = Vec2(-u.y, u.x) * e.number(40, 1);
            if (glm::length(v) > 0) ellipse_arc(map, e.at[0], u, v, e.number(41, 0), e.number(42, 2 * kPi));
        } else if (e.type == "SPLINE" && is_one_bezier(e)) {
            Stroke stroke{map.point(e.vertices[0].at), {{static_cast<int>(e.vertices.size()) - 1, {}, 0}}};
            for (std::size_t i = 1; i < e.vertices.size(); ++i) stroke.sides[0].p[i - 1] = map.point(e.vertices[i].at);
            if (stroke.end() == stroke.start) closed_.push_back({stroke.start, std::move(stroke.sides)});
            else strokes_.push_back(std::move(stroke));
        } else if (e.type == "LWPOLYLINE" || e.type == "POLYLINE") {
            polyline(e, map);
        } else if (e.type != "DIMENSION" && e.type != "TEXT" && e.type != "MTEXT" && e.type != "POINT" && e.type != "VIEWPORT" && e.type != "ATTRIB" && e.type != "ATTDEF") {
            ++others_[e.type];
        }
    }

    // Of degree 2 or 3, clamped at both ends, with no knots between and no weights.
    static bool is_one_bezier(const DxfEntity& e) {
        const std::size_t points = e.vertices.size(), degree = points - 1;
        if ((points != 3 && points != 4) || e.number(71, 0) != static_cast<double>(degree) || e.knots.size() != 2 * points || e.number(41, 1) != 1) return false;
        const auto first = e.knots.begin(), middle = first + static_cast<std::ptrdiff_t>(points);
        return std::count(first, middle, e.knots.front()) == static_cast<std::ptrdiff_t>(points) && std::count(middle, e.knots.end(), e.knots.back()) == static_cast<std::ptrdiff_t>(points) &&
               e.knots.front() < e.knots.back();
    }

    // Counter-clockwise from one angle to the other; the same or a whole turn apart: all of it.
    void ellipse_arc(const PlaneMap& map, Vec2 centre, Vec2 u, Vec2 v, double from, double to) {
        OutlineBuilder builder;
        double sweep = to - from;
        sweep -= 2 * kPi * std::floor(sweep / (2 * kPi));
        constexpr double kTwoRoundings = 2 * 0.5e-9;  // both ends are written with nine decimals or more
        if (sweep < kTwoRoundings || 2 * kPi - sweep < kTwoRoundings) {
            add_ellipse(builder, map, centre, u, v);
            return take_closed(builder);
        }
        const auto at = [&](double t) { return centre + u * std::cos(t) + v * std::sin(t); };
        const Vec2 start = map.point(at(from));
        if (map.point(at(from + sweep)) == start) return;  // no larger than roundings
        builder.move_to(map, at(from));
        builder.arc(map, centre, u, v, from, sweep, at(from + sweep));
        auto contours = builder.take();
        auto& sides = contours[0].sides;
        sides.pop_back();  // the line that closes it
        strokes_.push_back({start, std::move(sides)});
    }

    void polyline(const DxfEntity& e, const PlaneMap& map) {
        const auto& v = e.vertices;
        const bool closed = (static_cast<int>(e.number(70, 0)) & 1) != 0;
        if (v.size() < 2) return;
        const double sign = map.determinant() < 0 ? -1 : 1;
        Stroke stroke{map.point(v[0].at), {}};
        for (std::size_t i = 0; i < v.size(); ++i) {
            if (i + 1 == v.size() && !closed) break;
            const Vec2 to = v[(i + 1) % v.size()].at;
            if (to != v[i].at) stroke.sides.push_back(DrawnSide::arc(map.point(to), sign * v[i].bulge));
        }
        if (stroke.sides.empty()) return;
        if (closed || stroke.end() == stroke.start) closed_.push_back({stroke.start, std::move(stroke.sides)});
        else strokes_.push_back(std::move(stroke));
    }

    void take_closed(OutlineBuilder& builder) {
        for (auto& contour : builder.take()) closed_.push_back(std::move(contour));
    }

    // Chains strokes end to end until they close.
    void join() {
        std::multimap<std::pair<std::int64_t, std::int64_t>, std::size_t> by_cell;
        const auto along = [](double x) { return std::isnan(x) ? 0 : static_cast<std::int64_t>(std::floor(std::clamp(x, -1e15, 1e15) / kJoin)); };
        const auto cell = [along](Vec2 p) { return std::pair(along(p.x), along(p.y)); };
        for (std::size_t i = 0; i < strokes_.size(); ++i) by_cell.emplace(cell(strokes_[i].start), i), by_cell.emplace(cell(strokes_[i].end()), i);
        std::vector<bool> used(strokes_.size());
        // The nearest stroke not used yet with an end at p; the lower number of equals.
        const auto at = [&](Vec2 p) {
            std::size_t best = strokes_.size();
            double nearest = kJoin;
            for (std::int64_t dx = -1; dx <= 1; ++dx)
                for (std::int64_t dy = -1; dy <= 1; ++dy) {
                    const auto c = cell(p);
                    const auto [from, to] = by_cell.equal_range({c.first + dx, c.second + dy});
                    for (auto it = from; it != to; ++it) {
                        if (used[it->second]) continue;
                        const double d = std::min(glm::length(strokes_[it->second].start - p), glm::length(strokes_[it->second].end() - p));
                        if (d < nearest || (d == nearest && it->second < best)) nearest = d, best = it->second;
                    }
                }
            return best;
        };
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            if (used[i]) continue;
            used[i] = true;
            Stroke chain = strokes_[i];
            for (int way = 0; way < 2; ++way) {
                while (glm::length(chain.end() - chain.start) >= kJoin || chain.sides.size() < 2) {
                    const std::size_t next = at(chain.end());
                    if (next == strokes_.size()) break;
                    used[next] = true;
                    append(chain, strokes_[next]);
                }
                if (glm::length(chain.end() - chain.start) < kJoin) break;
                chain = reversed(chain);
            }
            if (glm::length(chain.end() - chain.start) >= kJoin) ++open_;
            closed_.push_back({chain.start, std::move(chain.sides)});
        }
    }

    static void append(Stroke& chain, const Stroke& next) {
        const bool forward = glm::length(next.start - chain.end()) <= glm::length(next.end() - chain.end());
        const Stroke piece = forward ? next : reversed(next);
        chain.sides.insert(chain.sides.end(), piece.sides.begin(), piece.sides.end());
    }

    const DxfFile& file_;
    const DrawingRequest& request_;
    std::vector<Stroke> strokes_;
    std::vector<DrawnContour> closed_;
    std::map<std::string, std::size_t> others_;
    std::set<std::string> open_blocks_;  // being inserted
    std::size_t open_ = 0, inserted_ = 0;
};

Result<DxfFile> entities_of(const std::string& text) {
    DxfFile file = read_dxf_entities(text);
    if (!file.whole) return fail(Fault::kWorld, "not a whole DXF: no pairs of code and value with an end");
    return file;
}

double degrees(Vec2 v) { return std::atan2(v.x, v.y) * 180 / kPi; }

}  // namespace

Result<Drawing> read_dxf(const std::string& text, const DrawingRequest& request) {
    const auto file = entities_of(text);
    if (!file) return tl::unexpected(file.error());
    DxfReader reader(*file, request);
    if (const auto gathered = reader.gather(); !gathered) return tl::unexpected(gathered.error());
    return reader.drawing();
}

Result<double> read_dxf_dimension(const std::string& text, const std::string& name_of_file, const DrawingRequest& request, const std::string& name) {
    const auto file = entities_of(text);
    if (!file) return tl::unexpected(file.error());
    const auto is_it = [&](const DxfEntity& e) { return e.type == "DIMENSION" && (request.layer.empty() || request.layer == e.layer) && (name.empty() || e.text == name); };
    const auto found = std::find_if(file->entities.begin(), file->entities.end(), is_it);
    if (found == file->entities.end())
        return fail(Fault::kScene, fmt::format("Can't find dimension '{}' in '{}', layer '{}'!", name, name_of_file, request.layer));
    const auto at = [&](std::size_t i) { return (found->at[i] - request.origin) * request.scale; };
    const int type = static_cast<int>(found->number(70, 0));
    const double angle = found->number(50, 0) * kPi / 180;
    switch (type & 7) {
        case 0: return std::fabs(glm::dot(at(4) - at(3), Vec2(std::cos(angle), std::sin(angle))));
        case 1: return glm::length(at(4) - at(3));
        case 2: return std::fabs(degrees(at(0) - at(5)) - degrees(at(4) - at(3)));
        case 3:
        case 4: return glm::length(at(5) - at(0));
        case 6: return (type & 64) ? at(3).x : at(3).y;
        default: return fail(Fault::kScene, fmt::format("Dimension '{}' in '{}', layer '{}' has unsupported type!", name, name_of_file, request.layer));
    }
}

Result<Vec2> read_dxf_crossing(const std::string& text, const std::string& name_of_file, const DrawingRequest& request) {
    const auto file = entities_of(text);
    if (!file) return tl::unexpected(file.error());
    DxfReader reader(*file, request);
    if (const auto gathered = reader.gather(); !gathered) return tl::unexpected(gathered.error());
    std::vector<const Stroke*> lines;
    for (const Stroke& s : reader.strokes())
        if (s.sides.size() == 1 && s.sides[0].degree == 1 && s.sides[0].bulge == 0 && lines.size() < 2) lines.push_back(&s);
    if (lines.size() == 2) {
        const Vec2 a = lines[0]->end() - lines[0]->start, b = lines[1]->end() - lines[1]->start, between = lines[0]->start - lines[1]->start;
        const double area = b.y * a.x - b.x * a.y;
        if (area != 0) return lines[0]->start + a * ((b.x * between.y - b.y * between.x) / area);
    }
    return fail(Fault::kScene, fmt::format("Can't find cross in '{}', layer '{}'!", name_of_file, request.layer));
}

}  // namespace whittle
