#include "modeler/cli/summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csg/base/degrees.h"
#include "modeler/cli/answers.h"
#include "modeler/cli/console.h"
#include "modeler/cli/session.h"

namespace whittle {

namespace {

// A camera as OpenSCAD says it: where it looks, how it is turned there, from how far.
struct Gimbal {
    Vec3 translation{0}, rotation_deg{0};
    double distance = 0, fov_deg = 0;
};

// The rotation is Rz Ry Rx, whose columns are the lens' right, up and backward directions.
Gimbal gimbal_of(const Lens& lens) {
    const Vec3 back = -lens.forward;
    Gimbal out;
    out.distance = lens.target_distance;
    out.translation = lens.eye - back * out.distance;
    const double level = std::hypot(lens.up.z, back.z);
    const auto degrees = [](double y, double x) { return std::atan2(y, x) / kRadiansPerDegree; };
    out.rotation_deg.y = degrees(-lens.right.z, level);
    if (level > 0) {
        out.rotation_deg.x = degrees(lens.up.z, back.z);
        out.rotation_deg.z = degrees(lens.right.y, lens.right.x);
    } else {  // looking along a horizontal axis on its side: one of the two turns is free
        out.rotation_deg.z = degrees(-lens.up.x, lens.up.y);
    }
    out.fov_deg = 2 * degrees(lens.half_height, lens.orthographic ? out.distance : 1);
    return out;
}

struct Time {
    std::int64_t hours, minutes, seconds, milliseconds, total;
    std::string text() const { return fmt::format("{}:{:02}:{:02}.{:03}", hours, minutes, seconds, milliseconds); }
};

Time time_of(double seconds) {
    const std::int64_t ms = std::llround(seconds * 1000);
    return {ms / 3600000, ms / 60000 % 60, ms / 1000 % 60, ms % 1000, ms};
}

double area_of(const Mesh& mesh) {
    double area = 0;
    for (const Triangle& t : mesh.triangles) area += glm::length(glm::cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]])) / 2;
    return area;
}

// As many members as the set has dimensions.
std::vector<double> members(Vec3 v, int dimensions) { return dimensions == 2 ? std::vector<double>{v.x, v.y} : std::vector<double>{v.x, v.y, v.z}; }

// Never "-0.00".
std::string two_places(Vec3 v, int dimensions) {
    for (int i = 0; i < 3; ++i) v[i] = std::round(v[i] * 100) / 100 + 0.0;
    return fmt::format("{:.2f}", fmt::join(members(v, dimensions), ", "));
}

}  // namespace

bool SummaryRequest::has(std::string_view topic) const {
    const auto named = [this](std::string_view name) { return std::find(topics.begin(), topics.end(), name) != topics.end(); };
    return topics.empty() || named(topic) || named("all");
}

const std::vector<std::string>& summary_topics() {
    static const std::vector<std::string> kTopics{"all", "cache", "time", "camera", "geometry", "bounding-box", "area"};
    return kTopics;
}

void Summary::note(const std::vector<const MeshResult*>& parts) {
    MeshReport sum;
    bool simple = true;
    Bounds box;
    double area = 0;
    for (const MeshResult* part : parts) {
        const MeshReport& report = part->report;
        sum.vertices += report.vertices, sum.triangles += report.triangles, sum.components += report.components, sum.genus += report.genus;
        simple = simple && report.valid();
        const Bounds one = mesh_bounds(part->mesh);
        box = box.empty() ? one : Bounds{glm::min(box.lo, one.lo), glm::max(box.hi, one.hi)};
        area += area_of(part->mesh);
    }
    const auto count = [](std::uint64_t n) { return static_cast<std::int64_t>(n); };
    geometry_ = Geometry{3, simple, {{"vertices", count(sum.vertices)}, {"edges", count(sum.triangles * 3 / 2)}, {"facets", count(sum.triangles)},
                                     {"components", count(sum.components)}, {"genus", sum.genus}}, box, area};
}

void Summary::note(const std::vector<Outline>& outlines) {
    const OutlineBox box = box_of(outlines);
    geometry_ = Geometry{2, std::nullopt, {{"contours", static_cast<std::int64_t>(outlines.size())}}, {{box.lo, 0}, {box.hi, 0}}, whittle::area_of(outlines)};
}

void Summary::note(const Solid& solid, bool flat, const Lens& lens) {
    geometry_ = Geometry{flat ? 2 : 3, std::nullopt, {}, solid.root_bounds(), std::nullopt};
    nodes_ = solid.node_count();
    lens_ = lens;
}

std::string Summary::geometry_json(const Geometry& g) const {
    json::Object out;
    out.number("dimensions", g.dimensions);
    if (request_.has("geometry")) {
        if (g.simple) out.boolean("simple", *g.simple);
        for (const auto& [name, count] : g.counts) out.number(name, static_cast<double>(count));
    }
    const auto corner = [&g](Vec3 v) { return members(v, g.dimensions); };
    if (request_.has("bounding-box") && !g.box.empty())
        out.raw("bounding_box", json::Object().numbers("min", corner(g.box.lo)).numbers("max", corner(g.box.hi)).numbers("size", corner(g.box.hi - g.box.lo)).str());
    if (request_.has("area") && g.area) out.number("area", *g.area);
    return out.str();
}

std::string Summary::json(double seconds) const {
    json::Object out;
    if (request_.has("cache")) out.raw("cache", json::Object().raw("geometry_cache", json::Object().count("entries", nodes_).str()).str());
    if (request_.has("camera") && lens_) {
        const Gimbal g = gimbal_of(*lens_);
        out.raw("camera", json::Object().triple("translation", g.translation).triple("rotation", g.rotation_deg).number("distance", g.distance).number("fov", g.fov_deg).str());
    }
    if (geometry_ && (request_.has("geometry") || request_.has("bounding-box") || request_.has("area"))) out.raw("geometry", geometry_json(*geometry_));
    if (request_.has("time")) {
        const Time t = time_of(seconds);
        json::Object time;
        time.string("time", t.text()).number("total", static_cast<double>(t.total)).number("milliseconds", static_cast<double>(t.milliseconds));
        time.number("seconds", static_cast<double>(t.seconds)).number("minutes", static_cast<double>(t.minutes)).number("hours", static_cast<double>(t.hours));
        out.raw("time", time.str());
    }
    return out.str() + "\n";
}

std::vector<std::string> Summary::geometry_lines(const Geometry& g) const {
    std::vector<std::string> out;
    if (request_.has("geometry")) {
        out.push_back(fmt::format("Top level object is a {}D object:", g.dimensions));
        if (g.simple) out.push_back(fmt::format("   {:<12}{:>6}", "Simple:", *g.simple ? "yes" : "no"));
        for (const auto& [name, count] : g.counts) {
            std::string shown = std::string(name) + ":";
            shown[0] = static_cast<char>(shown[0] - 'a' + 'A');
            out.push_back(fmt::format("   {:<12}{:>6}", shown, count));
        }
    }
    if (request_.has("bounding-box") && !g.box.empty()) {
        const auto corner = [&g](Vec3 v) { return two_places(v, g.dimensions); };
        out.insert(out.end(), {"Bounding box:", "   Min:  " + corner(g.box.lo), "   Max:  " + corner(g.box.hi), "   Size: " + corner(g.box.hi - g.box.lo)});
    }
    if (request_.has("area") && g.area) out.insert(out.end(), {"Measurements:", fmt::format("   Area: {:.2f}", *g.area)});
    return out;
}

std::vector<std::string> Summary::lines(double seconds) const {
    std::vector<std::string> out;
    if (request_.has("cache")) out.push_back(fmt::format("Geometries in cache: {}", nodes_));
    if (request_.has("time")) out.push_back("Total rendering time: " + time_of(seconds).text());
    if (geometry_)
        for (auto& line : geometry_lines(*geometry_)) out.push_back(std::move(line));
    if (lens_ && request_.has("camera")) {
        const Gimbal g = gimbal_of(*lens_);
        out.insert(out.end(), {"Camera:", "   Translation: " + two_places(g.translation, 3), "   Rotation:    " + two_places(g.rotation_deg, 3),
                               fmt::format("   Distance:    {:.2f}", g.distance), fmt::format("   FOV:         {:.2f}", g.fov_deg)});
    }
    return out;
}

Result<void> Summary::tell(Console& console, double seconds) const {
    if (!wanted()) return {};
    if (!request_.file.empty()) return write_output(request_.file, json(seconds));
    for (const auto& line : lines(seconds)) console.line(line);
    return {};
}

}  // namespace whittle
