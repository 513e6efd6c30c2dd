// test_light_examples.cpp — every example can be lit by every integrator, and no sample of any is no number.
#include <filesystem>

#include <catch2/catch.hpp>

#include "tests/examples/scenes.h"
#include "tracer/light/render.h"

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

// A small sky, whatever file is asked for: reading files is tested with the program.
Result<Image> any_sky(const std::string&, const SourcePlace&) {
    Image image;
    image.width = 4;
    image.height = 2;
    image.channels = {"R", "G", "B"};
    image.types.assign(3, ChannelType::kFloat);
    image.floats.assign(24, 0.5f);
    return image;
}

}  // namespace

TEST_CASE("examples with light in them give numbers with every integrator, and auto takes the one they promise") {
    const auto paths = scenes_in(kFolder + "/light");
    CHECK(paths.size() >= 10);
    for (const std::string& path : paths) {
        INFO(path);
        const ReadScene read = read_scene(path);
        CHECK(read.messages.empty());
        const auto program = compile(read.canonical.solid);
        REQUIRE(program);
        RenderScene scene{read.lights, read.camera, {}, {}, &read.canonical.solid, any_sky};
        for (Integrator kind : {Integrator::kAuto, Integrator::kWhitted, Integrator::kDistributed, Integrator::kPath, Integrator::kCaustics, Integrator::kCone}) {
            INFO(integrator_name(kind));
            RenderControl control;
            const Result<RenderResult> r = render(*program, scene, tiny(kind), control);
            REQUIRE(r);
            CHECK(r->counters.no_numbers == 0);
            CHECK(r->film.missing_pixels() == 0);
            if (kind == Integrator::kAuto && !promised(text_of(path)).empty()) CHECK(integrator_name(r->integrator) == promised(text_of(path)));
        }
        CHECK(std::filesystem::exists(WHITTLE_SOURCE_DIR "/docs/gallery/" + std::filesystem::path(path).stem().string() + ".png"));
    }
}
