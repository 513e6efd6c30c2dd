// file_scene.cpp — a scene file as something to time.
#include "bench/scenes.h"

#include "csg/eval/canonicalise.h"
#include "csg/eval/evaluate.h"
#include "modeler/io/files.h"
#include "tracer/engine/engine.h"

namespace whittle::bench {

Result<BenchScene> file_scene(const std::string& path, bool faceted) {
    Files files;
    EvaluateInput input;
    input.path = path;
    input.library_paths = library_paths();
    Result<Evaluated> evaluated = evaluate(input, files);
    if (!evaluated) return tl::unexpected<Error>(evaluated.error());
    if (evaluated->stopped()) return tl::unexpected<Error>(Error{Fault::kScene, path + " does not run to its end"});
    CanonicaliseOptions options;
    options.curves = faceted ? Curves::kFaceted : Curves::kExact;
    Canonical canonical = canonicalise(evaluated->scene, options, &files, evaluated->diagnostics);
    auto program = compile(canonical.solid);
    if (!program) return tl::unexpected<Error>(program.error());
    BenchScene scene;
    scene.name = path;
    scene.what = faceted ? "faceted" : "true curves";
    scene.box = program_bounds(**program);
    scene.centre = 0.5 * (scene.box.lo + scene.box.hi);
    scene.radius = 0.5 * glm::length(scene.box.hi - scene.box.lo);
    scene.primitives = static_cast<double>(build_report(**program).leaves);
    scene.solid = std::move(canonical.solid);
    scene.meshable = true;
    return scene;
}

}  // namespace whittle::bench
