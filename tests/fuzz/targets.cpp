#include "tests/fuzz/targets.h"

#include <array>
#include <new>
#include <string>

#include "csg/eval/dump_csg.h"
#include "csg/eval/evaluate.h"
#include "csg/eval/json_value.h"
#include "modeler/io/dxf.h"
#include "modeler/io/heights.h"
#include "modeler/io/svg.h"
#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/package_reader.h"

namespace whittle::fuzz {
namespace {

// No files: what a scene includes or imports is missing.
class Nothing : public Outside {
public:
    Result<std::string> read_text(const std::string& path) override { return fail(Fault::kWorld, "no such file: " + path); }
    bool exists(const std::string&) override { return false; }
};

EvaluateInput input_of(std::string_view bytes) {
    EvaluateInput input;
    input.path = "fuzz.scad";
    input.text = std::string(bytes);
    input.limits.seconds = 1;
    input.limits.memory_bytes = std::uint64_t{64} << 20;
    return input;
}

void run_parser(std::string_view bytes) {
    Nothing outside;
    (void)parse(input_of(bytes), outside);
}

void run_evaluator(std::string_view bytes) {
    Nothing outside;
    const auto made = evaluate(input_of(bytes), outside);
    if (!made) return;
    (void)echo_text(made->diagnostics, made->sources);
    constexpr std::size_t kMostNodes = 10000;
    if (made->scene.nodes.size() < kMostNodes) (void)dump_csg(made->scene);
}

void run_mesh(std::string_view bytes, const char* path) { (void)read_mesh(bytes, path); }
void run_stl(std::string_view bytes) { run_mesh(bytes, "fuzz.stl"); }
void run_off(std::string_view bytes) { run_mesh(bytes, "fuzz.off"); }
void run_obj(std::string_view bytes) { run_mesh(bytes, "fuzz.obj"); }
void run_ply(std::string_view bytes) { run_mesh(bytes, "fuzz.ply"); }
void run_3mf(std::string_view bytes) { (void)read_3mf(bytes); }
void run_amf(std::string_view bytes) { (void)read_amf(bytes); }
void run_dxf(std::string_view bytes) { (void)read_dxf(std::string(bytes), {}); }
void run_svg(std::string_view bytes) { (void)read_svg(std::string(bytes), {}); }
void run_json(std::string_view bytes) {
    Heap heap;
    heap.set_limit(std::uint64_t{64} << 20);
    try {
        (void)json_value(heap, bytes);
    } catch (const std::bad_alloc&) {
    }
}
// What a reader of the syntax does not run: the program back as text, and its customizer.
void run_syntax(std::string_view bytes) {
    Nothing outside;
    const auto parsed = parse(input_of(bytes), outside);
    if (!parsed || !parsed->program) return;
    (void)ast_text(*parsed);
    (void)parameters_text(*parsed);
}
void run_heights(std::string_view bytes) { (void)read_heights(std::string(bytes)); }

constexpr std::array kTargets = std::to_array<Target>({
    {"parser", run_parser},
    {"evaluator", run_evaluator},
    {"stl", run_stl},
    {"off", run_off},
    {"obj", run_obj},
    {"ply", run_ply},
    {"3mf", run_3mf},
    {"amf", run_amf},
    {"dxf", run_dxf},
    {"svg", run_svg},
    {"heights", run_heights},
    {"json", run_json},
    {"syntax", run_syntax},
});

}  // namespace

std::span<const Target> targets() { return kTargets; }

}  // namespace whittle::fuzz
