// test_corpus.cpp — the program writes for every scene of tests/corpus the .echo and the .csg that OpenSCAD 2021.01 writes, but where differences.txt has a reason.
#include <catch2/catch.hpp>

#include "run_program.h"
#include "tests/support/corpus.h"

using namespace whittle::test;

namespace {

std::string stored(const std::string& name) {
    std::stringstream text;
    text << std::ifstream(corpus_folder() / name, std::ios::binary).rdbuf();
    return text.str();
}

// What `whittle -o` writes for a scene, asked for in its folder; whether it wrote anything.
std::pair<std::string, bool> written(const TemporaryFolder& folder, const std::string& name, const std::string& suffix) {
    const std::string out = folder.name(name + suffix);
    run_whittle({"-o", out, name + ".scad"}, {"", corpus_folder().string(), 0, ""});
    const bool is_there = std::filesystem::exists(out);
    return {is_there ? folder.read(name + suffix) : "", is_there};
}

}  // namespace

TEST_CASE("the program's .echo files of the corpus are OpenSCAD's") {
    const TemporaryFolder folder;
    const auto differ = corpus_differences("echo");
    int same = 0;
    for (const std::string& name : corpus_scenes()) {
        INFO(name);
        const bool equal = written(folder, name, ".echo").first == stored(name + ".echo");
        CHECK(equal == (differ.count(name) == 0));
        same += equal;
    }
    CHECK(same >= 350);
}

TEST_CASE("the program's .csg files of the corpus are OpenSCAD's, and a scene that stopped early has none") {
    const TemporaryFolder folder;
    const auto differ = corpus_differences("csg"), none = corpus_differences("file");
    int same = 0;
    for (const std::string& name : corpus_scenes()) {
        if (!std::filesystem::exists(corpus_folder() / (name + ".csg"))) continue;
        INFO(name);
        const auto [text, is_there] = written(folder, name, ".csg");
        CHECK(is_there == (none.count(name) == 0));
        if (!is_there) continue;
        const bool equal = text == stored(name + ".csg");
        CHECK(equal == (differ.count(name) == 0));
        same += equal;
    }
    CHECK(same >= 330);
}
