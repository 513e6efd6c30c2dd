// test_layering.cpp — the floors hold: no include goes up, heavy libraries stay in their places, the top level has only known folders.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "includes.h"
#include "type_names.h"

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = WHITTLE_SOURCE_DIR;

bool is_source(const fs::path& path) {
    const auto suffix = path.extension();
    return suffix == ".h" || suffix == ".cpp" || suffix == ".inl";
}

std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::vector<fs::path> sources() {
    std::vector<fs::path> found;
    for (const char* floor : {"csg", "tracer", "modeler", "tests", "bench"}) {
        if (!fs::exists(kRoot / floor)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / floor))
            if (entry.is_regular_file() && is_source(entry.path())) found.push_back(fs::relative(entry.path(), kRoot));
    }
    std::sort(found.begin(), found.end());
    return found;
}

// Files that include one of the libraries of about a minute's compile time each.
std::set<std::string> including(const std::string& prefix) {
    std::set<std::string> files;
    for (const auto& file : sources())
        for (const auto& include : includes_in(file.generic_string(), read(kRoot / file)))
            if (include.header.rfind(prefix, 0) == 0 && file.generic_string().rfind("tests/", 0) != 0 && file.generic_string().rfind("bench/", 0) != 0)
                files.insert(include.file);
    return files;
}

}  // namespace

TEST_CASE("no include line of the project breaks a rule of the floors") {
    const auto files = sources();
    REQUIRE(files.size() > 20);
    for (const auto& file : files)
        for (const auto& include : includes_in(file.generic_string(), read(kRoot / file)))
            for (const auto& rule : broken_rules(include)) {
                INFO(include.file << ":" << include.line << " includes " << include.header);
                CHECK(rule == "");
            }
}

TEST_CASE("no two files of the project define a type of one name") {
    std::map<std::string, std::set<std::string>> files_of;
    for (const auto& file : sources())
        for (const std::string& type : types_defined_in(read(kRoot / file))) files_of[type].insert(file.generic_string());
    REQUIRE(files_of.size() > 200);
    const auto is_test = [](const std::string& file) { return file.rfind("tests/", 0) == 0; };  // a program each: these may share names among themselves
    for (const auto& [type, files] : files_of) {
        std::string all;
        for (const auto& file : files) all += ' ' + file;
        INFO(type << " stands in" << all);
        CHECK((files.size() == 1 || std::all_of(files.begin(), files.end(), is_test)));
    }
}

TEST_CASE("the reader of types knows namespaces and leaves out what is declared or hidden") {
    const auto found = types_defined_in(
        "struct A;\nstruct B {\n};\nnamespace n {\nclass alignas(64) C final : public D {\n    struct Inner {};\n};\nnamespace {\nstruct E {};\n}  // namespace\n"
        "enum class F : int { kX };\nstruct F::Impl {};\n}  // namespace n\nunion G {};\n");
    CHECK(found == std::vector<std::string>{"B", "n::C", "n::F", "n::F::Impl", "G"});
}

TEST_CASE("the reader of include lines sees what a compiler sees") {
    const auto found = includes_in("csg/a.cpp", "#include <map>\n  #  include \"csg/b.h\"\n// #include \"tracer/c.h\"\nint x; // #include\n");
    REQUIRE(found.size() == 2);
    CHECK(found[0].header == "map");
    CHECK(found[1].header == "csg/b.h");
    CHECK(found[1].line == 2);
}

TEST_CASE("each rule of the floors is broken by an include that goes up or stands in the wrong place") {
    const std::vector<Include> wrong{
        {"csg/solid/x.cpp", "tracer/engine/engine.h", 1}, {"csg/base/x.h", "modeler/io/files.h", 1},  {"tracer/light/x.cpp", "modeler/io/files.h", 1},
        {"modeler/mesh/x.cpp", "tracer/engine/engine.h", 1}, {"csg/lang/x.h", "csg/eval/scene.h", 1}, {"csg/solid/x.h", "csg/eval/scene.h", 1},
        {"tracer/engine/x.cpp", "tracer/light/render.h", 1}, {"modeler/io/x.cpp", "modeler/cli/options.h", 1}, {"csg/lang/x.cpp", "../base/vec.h", 1},
        {"modeler/cli/x.h", "CLI/CLI.hpp", 1}, {"tracer/light/x.cpp", "CGAL/Nef_3.h", 1}, {"modeler/cli/x.cpp", "OpenMesh/Core/IO.hh", 1},
        {"modeler/cli/x.cpp", "OpenImageIO/imageio.h", 1}, {"modeler/cli/x.cpp", "CLI/CLI.hpp", 1}, {"tracer/engine/x.cpp", "embree3/rtcore.h", 1},
        {"csg/lang/x.cpp", "catch2/catch.hpp", 1}};
    std::set<std::string> broken;
    for (const auto& include : wrong) {
        INFO(include.file << " includes " << include.header);
        const auto names = broken_rules(include);
        CHECK_FALSE(names.empty());
        broken.insert(names.begin(), names.end());
    }
    for (const auto& rule : layering_rules()) {
        INFO(rule.name);
        CHECK(broken.count(rule.name) == 1);
    }
    CHECK(broken_rules({"tracer/engine/x.cpp", "csg/solid/solid.h", 1}).empty());
    CHECK(broken_rules({"modeler/cli/x.cpp", "tracer/light/render.h", 1}).empty());
    CHECK(broken_rules({"csg/solid/solid.h", "csg/eval/matter.h", 1}).empty());
}

TEST_CASE("OpenImageIO is included by one file") { CHECK(including("OpenImageIO/").size() <= 1); }

TEST_CASE("the top level holds known folders only") {
    const std::set<std::string> allowed{".ci", ".git", ".cache", "bench", "build", "csg", "docs", "examples", "modeler", "share", "tests", "tracer"};
    for (const auto& entry : fs::directory_iterator(kRoot))
        if (entry.is_directory()) {
            INFO(entry.path());
            CHECK(allowed.count(entry.path().filename().string()) == 1);
        }
}
