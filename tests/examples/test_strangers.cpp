// test_strangers.cpp — the examples that Debian's package openscad installs: our facets and what openscad exports have one volume and one area.
//
// Runs where the package is installed.
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
// Of openscad's coordinates: it keeps five or six digits in OFF files and puts polygons on a grid of 2^-10 to 2^-20.
constexpr double kRelative = 2e-5;

// 3D scenes of what the language has so far, without those whose nested differences take openscad minutes. Others need text, files, projection, hull.
const std::vector<const char*> kScenes{"Basics/CSG.scad", "Basics/CSG-modules.scad", "Basics/linear_extrude.scad", "Basics/logo.scad",
                                       "Functions/functions.scad", "Old/example001.scad", "Old/example002.scad", "Old/example003.scad",
                                       "Old/example004.scad", "Old/example005.scad", "Old/example011.scad", "Old/example014.scad",
                                       "Old/example017.scad", "Old/example018.scad", "Old/example019.scad", "Old/example022.scad",
                                       "Advanced/assert.scad", "Advanced/offset.scad", "Parametric/candleStand.scad"};

// Parts that abut under a turn of 60 degrees: rounded apart, openscad leaves both walls between them; here they are one surface and go.
const std::string kKeepsInnerWalls = "Old/example017.scad";

// Volume and area of an OFF file whose facets may have any number of corners.
struct Sizes { double volume = 0, area = 0; };

Sizes sizes_of_off(const std::string& path) {
    std::ifstream in(path);
    std::string word;
    std::size_t points = 0, facets = 0, edges = 0;
    in >> word >> points >> facets >> edges;
    REQUIRE(word == "OFF");
    std::vector<Vec3> p(points);
    for (Vec3& v : p) in >> v.x >> v.y >> v.z;
    Sizes s;
    for (std::size_t f = 0; f < facets; ++f) {
        std::size_t n = 0;
        in >> n;
        std::vector<std::size_t> corners(n);
        for (std::size_t& c : corners) in >> c;
        std::getline(in, word);  // a colour may follow
        Vec3 normal(0);
        for (std::size_t k = 1; k + 1 < n; ++k) normal += glm::cross(p[corners[k]] - p[corners[0]], p[corners[k + 1]] - p[corners[0]]);
        s.area += glm::length(normal) / 2;
        s.volume += glm::dot(p[corners[0]], normal) / 6;
    }
    REQUIRE(in);
    return s;
}

Sizes exported_by_openscad(const std::string& scene) {
    const std::string out = (std::filesystem::temp_directory_path() / ("strangers-" + std::to_string(getpid()) + ".off")).string();
    const std::string command = "openscad -o '" + out + "' '" + scene + "' >/dev/null 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    const Sizes s = sizes_of_off(out);
    std::filesystem::remove(out);
    return s;
}

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

TEST_CASE("facets of the examples that come with openscad have the volume and area that openscad exports") {
    if (!is_installed()) {
        WARN("openscad is not installed: nothing to compare with");
        return;
    }
    for (const char* name : kScenes) {
        CAPTURE(name);
        if (!std::filesystem::exists(kFolder + name)) continue;
        const ReadScene scene = read_scene(kFolder + name, {}, Curves::kFaceted);
        CHECK_FALSE(scene.stopped);
        CHECK_FALSE(scene.canonical.something_left_out);
        MeshControl control;
        const auto made = mesh_solid(scene.canonical.solid, {}, control);
        REQUIRE(made);
        const MassProperties ours = mass_properties(made->mesh);
        const Sizes theirs = exported_by_openscad(kFolder + name);
        CHECK(ours.volume == Approx(theirs.volume).epsilon(kRelative));
        if (name != kKeepsInnerWalls) CHECK(ours.area == Approx(theirs.area).epsilon(kRelative));
        else CHECK(ours.area < theirs.area);
    }
}
