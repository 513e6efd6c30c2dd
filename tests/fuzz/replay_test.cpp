// Every seed and every mutation of it that a fixed generator makes, through its target. What fuzzing finds is added to the seeds.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <catch2/catch.hpp>

#include "tests/fuzz/targets.h"

namespace fs = std::filesystem;
using namespace whittle;

namespace {

const fs::path kSeeds = fs::path(WHITTLE_SOURCE_DIR) / "tests" / "fuzz" / "seeds";

std::string bytes_of(const fs::path& path) {
    std::stringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

// One byte changed, a piece dropped, doubled or moved.
std::string changed(std::string text, std::mt19937& random) {
    if (text.empty()) return text;
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    const std::size_t at = below(text.size()), length = 1 + below(std::min<std::size_t>(16, text.size() - at));
    switch (below(4)) {
        case 0: text[at] = static_cast<char>(random()); break;
        case 1: text.erase(at, length); break;
        case 2: text.insert(below(text.size()), text.substr(at, length)); break;
        default: text.resize(at); break;
    }
    return text;
}

}  // namespace

TEST_CASE("every reader has seeds, takes them, and takes them damaged") {
    std::mt19937 random(1);
    for (const fuzz::Target& target : fuzz::targets()) {
        std::size_t seeds = 0;
        for (const auto& entry : fs::directory_iterator(kSeeds / target.name)) {
            INFO(entry.path());
            const std::string seed = bytes_of(entry.path());
            target.run(seed);
            ++seeds;
            for (int i = 0; i < 20; ++i) {
                std::string text = seed;
                for (int k = 0; k <= i % 4; ++k) text = changed(std::move(text), random);
                target.run(text);
            }
        }
        INFO(target.name);
        CHECK(seeds > 0);
    }
}

TEST_CASE("headers that promise more than there is are refused") {
    const auto run = [](std::string_view name, const std::string& bytes) {
        for (const fuzz::Target& target : fuzz::targets())
            if (target.name == name) return target.run(bytes);
    };
    std::string stl(80, ' ');
    stl += std::string("\xF0\xFF\xFF\x14", 4) + std::string(50, '\0');  // a gigabyte and more of triangles, one of them there
    run("stl", stl);
    run("off", "OFF\n4000000000 4000000000 0\n0 0 0\n");
    run("ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nelement face 4000000000\n"
               "property list uchar int vertex_index\nend_header\n0 0 0\n");
    run("ply", "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n");
    run("obj", "v 0 0 0\nf 1 2 4000000000\nf -9 0 1\n");
    run("3mf", "PK\x03\x04 and nothing else");
    SUCCEED("none took memory for what it was only promised");
}
