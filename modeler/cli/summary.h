// summary.h — --summary and --summary-file of OpenSCAD's later versions: what a run made, told once at its end.
//
// The jobs note what they make as they make it; nothing is measured where nobody asked. Member names and topics are OpenSCAD's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"
#include "csg/solid/flat_outline.h"
#include "modeler/mesh/mesh.h"
#include "tracer/light/camera.h"

namespace whittle {

class Console;

// What --summary asks for. A file named without a topic means all of them.
struct SummaryRequest {
    std::vector<std::string> topics;  // cache, time, camera, geometry, bounding-box, area, all
    std::string file;                 // "-": standard output; empty: plain lines among the messages
    bool wanted() const { return !topics.empty() || !file.empty(); }
    bool has(std::string_view topic) const;
};

// The topics --summary takes.
const std::vector<std::string>& summary_topics();

class Summary {
public:
    explicit Summary(const SummaryRequest& request) : request_(request) {}

    bool wanted() const { return request_.wanted(); }
    // What is noted last counts. Meshes are the parts of one model.
    void note(const std::vector<const MeshResult*>& parts);
    void note(const std::vector<Outline>& outlines);
    // The solid as it was read, and how it is looked at. Where no job notes more, this is what the summary tells of its shape.
    void note(const Solid& solid, bool flat, const Lens& lens);

    // Tells the console, or writes the file. `seconds`: how long the run took.
    Result<void> tell(Console& console, double seconds) const;

private:
    struct Geometry {
        int dimensions = 3;
        std::optional<bool> simple;
        std::vector<std::pair<const char*, std::int64_t>> counts;  // "vertices", "facets" ...
        Bounds box;
        std::optional<double> area;
    };
    std::string geometry_json(const Geometry& g) const;
    std::vector<std::string> geometry_lines(const Geometry& g) const;
    std::string json(double seconds) const;
    std::vector<std::string> lines(double seconds) const;

    const SummaryRequest& request_;
    std::optional<Geometry> geometry_;
    std::optional<Lens> lens_;
    std::size_t nodes_ = 0;  // of the solid, each kept once
};

}  // namespace whittle
