// The examples that Debian's package `openscad` installs, against the program itself: part of the test "oracle/geometry", which exists where it is installed.
#include <cstdlib>
#include <filesystem>
#include <regex>

#include <catch2/catch.hpp>

#include "csg/eval/dump_csg.h"
#include "modeler/io/files.h"
#include "tests/examples/scenes.h"

namespace fs = std::filesystem;
using namespace whittle;
using namespace whittle::test;

namespace {

const fs::path kExamples = "/usr/share/openscad/examples";

// Dates of files are not part of a scene.
std::string undated(const std::string& csg) { return std::regex_replace(csg, std::regex("timestamp = [0-9]+"), "timestamp = 0"); }

std::string theirs(const fs::path& scene, const fs::path& out) {
    const std::string command = "cd '" + scene.parent_path().string() + "' && openscad -o '" + out.string() + "' '" + scene.filename().string() + "' > /dev/null 2>&1";
    if (std::system(command.c_str()) != 0) return {};
    return text_of(out.string());
}

}  // namespace

TEST_CASE("installed examples flatten as OpenSCAD flattens them", "[.][oracle]") {
    REQUIRE(std::system("openscad -v > /dev/null 2>&1") == 0);
    REQUIRE(fs::is_directory(kExamples));
    const fs::path out = fs::temp_directory_path() / ("whittle_examples_" + std::to_string(std::hash<std::string>{}(fs::current_path().string())) + ".csg");
    int compared = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kExamples)) {
        const fs::path scene = entry.path();
        if (scene.extension() != ".scad") continue;
        const std::string wanted = theirs(scene, out);
        REQUIRE_FALSE(wanted.empty());
        Files files;
        EvaluateInput input;
        input.path = scene.string();
        input.library_paths = library_paths();  // some take what may be installed beside them
        input.preview = true;
        INFO(scene);
        CHECK(undated(dump_csg(evaluate(input, files)->scene)) == undated(wanted));
        ++compared;
    }
    fs::remove(out);
    CHECK(compared >= 40);
}
