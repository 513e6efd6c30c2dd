// The scenes of tests/corpus against what OpenSCAD 2021.01 answered for them, character for character.
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "tests/csg/eval/memory_files.h"
#include "tests/support/corpus.h"

namespace fs = std::filesystem;
using namespace whittle;
using namespace whittle::test;

namespace {

const fs::path kCorpus = corpus_folder();

std::string stored(const std::string& name) { return DiscFiles().read_text((kCorpus / name).string()).value_or(""); }

Evaluated evaluated(const std::string& scene) {
    DiscFiles files;
    EvaluateInput input;
    const fs::path before = fs::current_path();
    fs::current_path(kCorpus);  // messages and paths are relative to the scene's folder
    input.path = scene + ".scad";
    input.preview = true;
    Evaluated out = *evaluate(input, files);
    fs::current_path(before);
    return out;
}

}  // namespace

TEST_CASE("the corpus has the scenes it is meant to have") { CHECK(corpus_scenes().size() >= 360); }

TEST_CASE("messages of the corpus are OpenSCAD's") {
    const auto better_echo = corpus_differences("echo");
    CHECK(better_echo.size() == 11);
    for (const std::string& name : corpus_scenes()) {
        INFO(name);
        const Evaluated made = evaluated(name);
        const std::string ours = echo_text(made.diagnostics, made.sources);
        if (better_echo.count(name)) CHECK(ours != stored(name + ".echo"));
        else CHECK(ours == stored(name + ".echo"));
    }
}

TEST_CASE("flattened scenes of the corpus are OpenSCAD's") {
    const auto better_csg = corpus_differences("csg");
    for (const std::string& name : corpus_scenes()) {
        if (!fs::exists(kCorpus / (name + ".csg"))) continue;
        INFO(name);
        const std::string ours = dump_csg(evaluated(name).scene);
        if (better_csg.count(name)) CHECK(ours != stored(name + ".csg"));
        else CHECK(ours == stored(name + ".csg"));
    }
}

TEST_CASE("programs of the corpus are written back as OpenSCAD writes them, comments of the customizer included") {
    int compared = 0;
    for (const std::string& name : corpus_scenes()) {
        if (!fs::exists(kCorpus / (name + ".ast"))) continue;
        INFO(name);
        DiscFiles files;
        EvaluateInput input;
        input.path = (kCorpus / (name + ".scad")).string();
        CHECK(*ast_text(*parse(input, files)) == stored(name + ".ast"));
        ++compared;
    }
    CHECK(compared >= 2);
}

TEST_CASE("every fact of the language has tests, and every scene of the corpus a fact") {
    std::set<std::string> flat, named;
    std::istringstream geometry(DiscFiles().read_text(WHITTLE_SOURCE_DIR "/tests/geometry/corpus.txt").value_or(""));
    for (std::string line; std::getline(geometry, line);) flat.insert(line.substr(0, line.find(':')));
    std::istringstream facts(stored("facts.txt"));
    int count = 0;
    for (std::string line; std::getline(facts, line);) {
        const std::size_t bar = line.rfind(" | ");
        if (line.empty() || line[0] == '#') continue;
        INFO(line);
        REQUIRE(bar != std::string::npos);
        ++count;
        std::istringstream tests(line.substr(bar + 3));
        int found = 0;
        for (std::string name; tests >> name; ++found) {
            CAPTURE(name);
            if (name.rfind("geometry:", 0) == 0) CHECK(flat.count(name.substr(9)) == 1);
            else if (name.find('/') != std::string::npos) CHECK(fs::exists(fs::path(WHITTLE_SOURCE_DIR) / name));
            else CHECK(fs::exists(kCorpus / (name + ".scad")));
            named.insert(name);
        }
        CHECK(found > 0);
    }
    CHECK(count >= 100);
    for (const std::string& name : corpus_scenes()) {
        INFO(name);
        CHECK(named.count(name) == 1);
    }
}

TEST_CASE("a flattened scene evaluates to itself") {
    const auto better_csg = corpus_differences("csg");
    for (const std::string& name : corpus_scenes()) {
        if (!fs::exists(kCorpus / (name + ".csg")) || better_csg.count(name)) continue;
        if (name == "text_and_files") continue;  // timestamps and origins are not parameters
        const std::string flat = stored(name + ".csg");
        if (flat.find("inf") != std::string::npos || flat.find("1e+") != std::string::npos) continue;  // not numbers of the language
        INFO(name);
        CHECK(csg_of(flat) == flat);
    }
}
