// test_geometry.cpp — the scenes of tests/geometry, and the examples of Debian's package openscad where it is installed, in OpenSCAD's facets: volume,
// area and bounds as openscad 2021.01 exported them. The test "oracle/geometry" asks the installed program again for each of the scenes.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <unistd.h>

#include <catch2/catch.hpp>

#include "modeler/io/files.h"
#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/mesh_queries.h"
#include "tests/examples/scenes.h"

using namespace whittle;
using namespace whittle::test;

namespace {

const std::string kFolder = WHITTLE_SOURCE_DIR "/tests/geometry/";
// Of openscad's coordinates: booleans put them on a grid of 2^-20, 2D sets on one of 2^-16, and a file holds single precision.
constexpr double kRelative = 2e-5;

// Parts that abut under a turn of 60 degrees: rounded apart, openscad leaves both walls between them; here they are one surface and go. In openscad's STL the
// facets that lie against others facing them, within 0.01 mm, measure 888.00 mm2.
const std::string kKeepsInnerWalls = "Old/example017.scad";
constexpr double kInnerWalls = 888.0;

// In front of an example that is flat: extruded by 1 here.
const std::string kFlat = "flat:";

struct Facts { double volume = 0, area = 0; Vec3 lo{0}, hi{0}; };

std::vector<std::pair<std::string, std::string>> corpus() {
    std::vector<std::pair<std::string, std::string>> out;
    std::ifstream in(kFolder + "corpus.txt");
    for (std::string line; std::getline(in, line);)
        if (const auto colon = line.find(": "); colon != std::string::npos && line[0] != '#') out.emplace_back(line.substr(0, colon), line.substr(colon + 2));
    return out;
}

std::map<std::string, Facts> stored_facts(const std::string& file) {
    std::map<std::string, Facts> out;
    std::ifstream in(kFolder + file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        Facts f;
        if (words >> name >> f.volume >> f.area >> f.lo.x >> f.lo.y >> f.lo.z >> f.hi.x >> f.hi.y >> f.hi.z) out[name] = f;
    }
    return out;
}

Facts facts_of(const Mesh& mesh) {
    const MassProperties mass = mass_properties(mesh);
    const Bounds box = mesh_bounds(mesh);
    return {mass.volume, mass.area, box.lo, box.hi};
}

// Of a scene in OpenSCAD's facets.
Facts made_by_us(EvaluateInput input) {
    input.library_paths = library_paths();
    Files files;
    auto evaluated = evaluate(input, files);
    REQUIRE(evaluated);
    CanonicaliseOptions options;
    options.curves = Curves::kFaceted;
    const Canonical canonical = canonicalise(evaluated->scene, options, &files, evaluated->diagnostics);
    CHECK_FALSE(canonical.something_left_out);
    MeshControl control;
    const auto made = mesh_solid(canonical.solid, {}, control);
    if (!made) FAIL(made.error().message);
    CHECK(made->report.valid());
    return facts_of(made->mesh);
}
Facts made_of_text(const std::string& text) {
    EvaluateInput input;
    input.path = "scene.scad";
    input.text = text;
    return made_by_us(input);
}
Facts made_of_file(const std::string& path) {
    EvaluateInput input;
    input.path = path;
    return made_by_us(input);
}

Facts made_by_openscad(const std::string& text) {
    const std::string base = (std::filesystem::temp_directory_path() / ("geometry-" + std::to_string(getpid()))).string();
    std::ofstream(base + ".scad") << text;
    const std::string command = "openscad --export-format binstl -o '" + base + ".stl' '" + base + ".scad' >/dev/null 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    const auto mesh = read_mesh(text_of(base + ".stl"), base + ".stl");
    std::filesystem::remove(base + ".scad");
    std::filesystem::remove(base + ".stl");
    REQUIRE(mesh);
    return facts_of(*mesh);
}

void check_same(const Facts& ours, const Facts& theirs) {
    CHECK(ours.volume == Approx(theirs.volume).epsilon(kRelative));
    CHECK(ours.area == Approx(theirs.area).epsilon(kRelative));
    const double size = glm::length(theirs.hi - theirs.lo);
    for (int i = 0; i < 3; ++i) {
        CHECK(std::fabs(ours.lo[i] - theirs.lo[i]) <= kRelative * size);
        CHECK(std::fabs(ours.hi[i] - theirs.hi[i]) <= kRelative * size);
    }
}

}  // namespace

TEST_CASE("scenes in OpenSCAD's facets have the volume, area and bounds that openscad exported") {
    const auto facts = stored_facts("openscad.txt");
    REQUIRE(corpus().size() >= 80);
    for (const auto& [name, text] : corpus()) {
        CAPTURE(name);
        REQUIRE(facts.count(name) == 1);
        check_same(made_of_text(text), facts.at(name));
    }
}

TEST_CASE("the examples that come with openscad, in its facets, have the volume, area and bounds that it exports") {
    const std::string folder = "/usr/share/openscad/examples/";
    if (!std::filesystem::is_directory(folder)) {
        WARN("openscad is not installed: its examples are not here");
        return;
    }
    int compared = 0;
    for (auto [name, theirs] : stored_facts("debian.txt")) {
        const bool flat = name.rfind(kFlat, 0) == 0;
        const std::string path = folder + (flat ? name.substr(kFlat.size()) : name);
        if (!std::filesystem::exists(path)) continue;
        ++compared;
        CAPTURE(name);
        const Facts ours = flat ? made_of_text("module whole() { include <" + path + ">\n}\nlinear_extrude(1) whole();") : made_of_file(path);
        if (name == kKeepsInnerWalls) {
            CHECK(theirs.area - ours.area == Approx(kInnerWalls).epsilon(1e-4));
            theirs.area = ours.area;
        }
        check_same(ours, theirs);
    }
    CHECK(compared >= 45);
}

TEST_CASE("what openscad exported is what it exports", "[.][oracle]") {
    const auto facts = stored_facts("openscad.txt");
    for (const auto& [name, text] : corpus()) {
        CAPTURE(name);
        check_same(made_by_openscad(text), facts.at(name));
    }
}
