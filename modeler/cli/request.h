// request.h — what a command line asks for, as plain values: parse.h makes it, the verbs read it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/eval/canonicalise.h"
#include "csg/span/ray.h"
#include "modeler/cli/memory.h"
#include "modeler/cli/summary.h"
#include "modeler/mesh/reference_mesh.h"
#include "tracer/image/image_file.h"
#include "tracer/light/render.h"

namespace whittle {

enum class Verb { kRender, kMesh, kCheck, kMeasure, kSpans, kMerge, kBench, kConvert };
enum class ProgressStyle { kAuto, kNever, kJson };
enum class DiagnosticStyle { kText, kJson };
enum class MeshEncoding { kDefault, kBinary, kAscii };

// Options of every verb.
struct CommonRequest {
    std::vector<std::string> definitions;  // -D, in order
    std::string parameter_file;            // -p
    std::string parameter_set;             // -P
    CanonicaliseOptions reading;           // --curves
    bool snap = true;
    int threads = 0;  // 0: all cores
    std::uint64_t seed = 0;
    ProgressStyle progress = ProgressStyle::kAuto;
    DiagnosticStyle diagnostics = DiagnosticStyle::kText;
    bool json = false;
    bool quiet = false;
    bool hard_warnings = false;
    bool check_parameters = true;
    bool allow_missing = false;
    std::string stats_file;
    std::string dependency_file;  // -d
    double limit_seconds = 0;     // 0: none
    MemoryLimit limit_memory = MemoryLimit::kSystem;
    std::uint64_t limit_bytes = 0;  // with MemoryLimit::kBytes
    std::vector<std::string> disabled_passes;
    double time = 0;  // $t
};

struct RenderRequest {
    RenderOptions options;      // sizes, samples, integrator ... as tracer/light takes them
    CameraSpec camera;          // --camera, --viewall, --autocenter, --projection
    PictureOptions picture;     // --exposure, --tonemap, channel type of an EXR
    std::vector<std::array<double, 4>> clips;  // n.p <= d is kept
    bool watch = false;
    bool resume = false;        // go on from the checkpoint
    RenderRequest() { options.noise.reset(); }  // the integrator's own
};

struct MeshRequest {
    MeshOptions options;  // --tolerance, --angle
    BooleanMaker booleans = BooleanMaker::kArrangement;
    MeshEncoding encoding = MeshEncoding::kDefault;
    bool report = false;
    std::optional<double> simplify_mm;  // Hausdorff distance at most
    std::optional<double> remesh_mm;    // sides of about this length
};

struct CheckRequest {
    std::uint64_t lines = 0;  // 0: by a count of work
    std::string heat_file;    // empty: none
    bool suite = false;       // many scenes, and folders of them
};

struct SpansRequest {
    std::vector<Ray> rays;     // --ray
    std::string rays_file;     // --rays; "-" is standard input
};

struct Request {
    Verb verb = Verb::kRender;
    std::vector<std::string> inputs;  // "-" is standard input
    std::vector<std::string> outputs;
    std::string export_format;             // --export-format, overrides the suffix
    int frames = 0;                        // --animate; 0: no animation
    SummaryRequest summary;                // --summary, --summary-file
    bool full_render = false;              // --render: a picture by OpenSCAD's form sees $preview = false
    std::vector<std::string> rest;         // bench: handed on as they are
    CommonRequest common;
    RenderRequest render;
    MeshRequest mesh;
    CheckRequest check;
    SpansRequest spans;
};

}  // namespace whittle
