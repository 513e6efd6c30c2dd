// test_light_examples.cpp — every example can be lit by every integrator, and no sample of any is no number.
#include <cmath>
#include <filesystem>

#include <catch2/catch.hpp>

#include "tests/examples/lit_scenes.h"

using namespace whittle;
using namespace whittle::test;

namespace {

const std::string kFolder = WHITTLE_SOURCE_DIR "/examples";

RenderOptions tiny(Integrator integrator) {
    RenderOptions o;
    o.width = 24;
    o.height = 18;
    o.samples = 2;
    o.max_depth = 8;
    o.integrator = integrator;
    return o;
}

// "// integrator: NAME" of a scene; empty: it says none.
std::string promised(const std::string& text) {
    const std::string key = "// integrator: ";
    const std::size_t at = text.find(key);
    return at == std::string::npos ? "" : text.substr(at + key.size(), text.find('\n', at) - at - key.size());
}

// Scans sums and planes: of samples that came out as no number none is left, and none was put right on the way.
void check_numbers(const RenderResult& r) {
    CHECK(r.counters.no_numbers == 0);
    CHECK(r.film.missing_pixels() == 0);
    std::size_t odd = 0;
    for (std::size_t i = 0; i < r.film.pixels.size(); ++i) {
        const Vec3 c = r.film.color(i);
        odd += !std::isfinite(c.x + c.y + c.z) || c.x < -1e-3 || c.y < -1e-3 || c.z < -1e-3;
    }
    CHECK(odd == 0);
}

bool has_picture(const std::string& path) { return std::filesystem::exists(WHITTLE_SOURCE_DIR "/docs/gallery/" + std::filesystem::path(path).stem().string() + ".png"); }

}  // namespace

TEST_CASE("examples with light in them give numbers with every integrator, and auto takes the one they promise") {
    const auto paths = scenes_in(kFolder + "/light");
    CHECK(paths.size() >= 16);
    for (const std::string& path : paths) {
        INFO(path);
        const LitScene lit = lit_scene(path);
        for (Integrator kind : {Integrator::kAuto, Integrator::kPreview, Integrator::kWhitted, Integrator::kDistributed, Integrator::kPath, Integrator::kCaustics, Integrator::kCone}) {
            INFO(integrator_name(kind));
            const RenderResult r = drawn(lit, tiny(kind));
            check_numbers(r);
            if (kind == Integrator::kAuto && !promised(text_of(path)).empty()) CHECK(integrator_name(r.integrator) == promised(text_of(path)));
        }
        CHECK(has_picture(path));
    }
}

TEST_CASE("every other example of the gallery gives numbers, in the studio or under its own lamps") {
    for (const std::string& path : scenes_in(kFolder)) {
        INFO(path);
        const LitScene lit = lit_scene(path);
        for (Integrator kind : {Integrator::kAuto, Integrator::kPath}) check_numbers(drawn(lit, tiny(kind)));
        CHECK(has_picture(path));
    }
}
