// What tests/corpus holds as OpenSCAD's answers, against the program itself: the test "oracle", which exists where the program is installed.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include <catch2/catch.hpp>

#include "tests/csg/eval/memory_files.h"

namespace fs = std::filesystem;
using namespace whittle;
using namespace whittle::test;

namespace {

const fs::path kCorpus = fs::path(WHITTLE_SOURCE_DIR) / "tests" / "corpus";

std::string undated(const std::string& csg) { return std::regex_replace(csg, std::regex("timestamp = [0-9]+"), "timestamp = 0"); }

std::string answer(const std::string& scene, const fs::path& out) {
    fs::remove(out);
    const std::string command = "cd '" + kCorpus.string() + "' && openscad -o '" + out.string() + "' '" + scene + ".scad' > /dev/null 2>&1";
    [[maybe_unused]] const int status = std::system(command.c_str());  // fails for scenes that are meant to fail; what it wrote counts
    return DiscFiles().read_text(out.string()).value_or("");
}

}  // namespace

TEST_CASE("the stored answers of the corpus are what the OpenSCAD program says", "[.][oracle]") {
    REQUIRE(std::system("openscad -v > /dev/null 2>&1") == 0);
    const fs::path folder = fs::temp_directory_path() / ("whittle_corpus_" + std::to_string(std::hash<std::string>{}(fs::current_path().string())));
    fs::create_directories(folder);
    int compared = 0;
    for (const auto& entry : fs::directory_iterator(kCorpus)) {
        if (entry.path().extension() != ".scad") continue;
        const std::string name = entry.path().stem().string();
        INFO(name);
        CHECK(answer(name, folder / "answer.echo") == DiscFiles().read_text((kCorpus / (name + ".echo")).string()).value_or(""));
        if (const fs::path csg = kCorpus / (name + ".csg"); fs::exists(csg))
            CHECK(undated(answer(name, folder / "answer.csg")) == DiscFiles().read_text(csg.string()).value_or(""));
        if (const fs::path ast = kCorpus / (name + ".ast"); fs::exists(ast)) CHECK(answer(name, folder / "answer.ast") == DiscFiles().read_text(ast.string()).value_or(""));
        ++compared;
    }
    fs::remove_all(folder);
    CHECK(compared >= 260);
}
