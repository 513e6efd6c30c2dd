// scenes.cpp — files through modeler/io, as the program reads them.
#include "tests/examples/scenes.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

#include "modeler/io/files.h"

namespace whittle::test {

ReadScene read_scene(const std::string& path, const std::vector<std::string>& definitions, Curves curves) {
    Files files;
    EvaluateInput input;
    input.path = path;
    input.definitions = definitions;
    input.library_paths = library_paths();
    auto evaluated = evaluate(input, files);
    REQUIRE(evaluated);
    ReadScene r;
    r.stopped = evaluated->stopped();
    r.lights = evaluated->scene.lights;
    r.camera = evaluated->scene.camera;
    CanonicaliseOptions options;
    options.curves = curves;
    r.canonical = canonicalise(evaluated->scene, options, &files, evaluated->diagnostics);
    for (const Diagnostic& d : evaluated->diagnostics.all())
        if (d.severity == Severity::kWarning || d.severity == Severity::kError) r.messages.push_back(format_line(d, evaluated->sources));
    return r;
}

std::string text_of(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> scenes_in(const std::string& folder) {
    std::vector<std::string> paths;
    if (!std::filesystem::is_directory(folder)) return paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".scad") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace whittle::test
