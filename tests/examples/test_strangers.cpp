// test_strangers.cpp — the examples that Debian's package openscad installs: spans and meshes agree; and openscad reads our examples.
//
// Runs where the package is installed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include <unistd.h>

#include <catch2/catch.hpp>

#include "modeler/check/agreement.h"
#include "modeler/mesh/mesh_queries.h"
#include "tests/examples/scenes.h"

using namespace whittle;
using namespace whittle::test;

namespace {

const std::string kFolder = "/usr/share/openscad/examples/";
// 3D scenes that both are quick with; the test [soak] takes every file. Volumes and areas of all are compared with what openscad exports in
// test_geometry.cpp.
const std::vector<const char*> kScenes{"Basics/CSG.scad", "Basics/CSG-modules.scad", "Basics/linear_extrude.scad", "Basics/logo.scad",
                                       "Functions/functions.scad", "Old/example001.scad", "Old/example002.scad", "Old/example003.scad",
                                       "Old/example004.scad", "Old/example005.scad", "Old/example011.scad", "Old/example014.scad",
                                       "Old/example017.scad", "Old/example018.scad", "Old/example019.scad", "Old/example022.scad",
                                       "Advanced/assert.scad", "Advanced/offset.scad", "Parametric/candleStand.scad"};

bool is_installed() { return std::filesystem::is_directory(kFolder) && std::system("openscad --version >/dev/null 2>&1") == 0; }

void agrees(const std::string& path, Curves curves) {
    const ReadScene scene = read_scene(path, {}, curves);
    MeshControl control;
    const auto made = mesh_solid(scene.canonical.solid, {}, control);
    REQUIRE(made);
    CHECK(made->report.valid());
    const auto program = compile(scene.canonical.solid);
    REQUIRE(program);
    AgreementOptions options;
    options.tolerance = made->tolerance_mm;
    options.rounding = made->grid_mm;
    options.lines = 1024;
    const auto a = check_agreement(scene.canonical.solid, **program, made->mesh, options);
    REQUIRE(a);
    CAPTURE(a->worst.distance, a->worst.bound, a->volume_spans.value, a->volume_mesh.value, a->tolerance);
    CHECK(a->agree);
}

}  // namespace

TEST_CASE("the examples that come with openscad agree with their meshes, true curves and facets") {
    if (!is_installed()) {
        WARN("openscad is not installed: its examples are not here");
        return;
    }
    for (const char* name : kScenes) {
        CAPTURE(name);
        if (!std::filesystem::exists(kFolder + name)) continue;
        agrees(kFolder + name, Curves::kAuto);
        agrees(kFolder + name, Curves::kFaceted);
    }
}

TEST_CASE("every example that comes with openscad agrees with its mesh, or is flat or empty and said so", "[.][soak]") {
    if (!is_installed()) {
        WARN("openscad is not installed: its examples are not here");
        return;
    }
    std::size_t solids = 0;
    std::vector<std::string> others;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kFolder)) {
        if (entry.path().extension() != ".scad") continue;
        CAPTURE(entry.path());
        const ReadScene scene = read_scene(entry.path(), {}, Curves::kAuto);
        if (scene.canonical.is_2d || scene.canonical.solid.root().node == kEmptyNode) {
            others.push_back(entry.path().filename());
            continue;
        }
        ++solids;
        agrees(entry.path(), Curves::kAuto);
    }
    std::sort(others.begin(), others.end());
    CHECK(others == std::vector<std::string>{"echo.scad", "example015.scad", "example023.scad", "list_comprehensions.scad", "module_recursion.scad",
                                             "polygon_areas.scad", "recursion.scad"});
    CHECK(solids == 41);
}

TEST_CASE("openscad reads every example of ours, with the module file that is shipped, without a warning") {
    if (!is_installed()) {
        WARN("openscad is not installed: nothing to read with");
        return;
    }
    for (const std::string& path : scenes_in(WHITTLE_SOURCE_DIR "/examples")) {
        CAPTURE(path);
        const std::string base = (std::filesystem::temp_directory_path() / ("strangers-" + std::to_string(getpid()))).string();
        const std::string command = "OPENSCADPATH='" WHITTLE_SOURCE_DIR "/share' openscad -o '" + base + ".csg' '" + path + "' >'" + base + ".log' 2>&1";
        CHECK(std::system(command.c_str()) == 0);
        const std::string log = text_of(base + ".log");
        CHECK(log.find("WARNING") == std::string::npos);
        CHECK(log.find("ERROR") == std::string::npos);
        CHECK(log.find("DEPRECATED") == std::string::npos);
        std::filesystem::remove(base + ".csg");
        std::filesystem::remove(base + ".log");
    }
}
