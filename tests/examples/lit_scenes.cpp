#include "tests/examples/lit_scenes.h"

#include <catch2/catch.hpp>

namespace whittle::test {

namespace {

Result<Image> grey_sky(const std::string&, const SourcePlace&) {
    Image image;
    image.width = 4;
    image.height = 2;
    image.channels = {"R", "G", "B"};
    image.types.assign(3, ChannelType::kFloat);
    image.floats.assign(24, 0.5f);
    return image;
}

}  // namespace

LitScene lit_scene(const std::string& path) {
    LitScene lit;
    lit.read = std::make_shared<const ReadScene>(read_scene(path));
    CHECK(lit.read->messages.empty());
    auto program = compile(lit.read->canonical.solid);
    REQUIRE(program);
    lit.program = *program;
    lit.scene = RenderScene{lit.read->lights, lit.read->camera, {}, {}, &lit.read->canonical.solid, grey_sky};
    return lit;
}

RenderResult drawn(const LitScene& lit, const RenderOptions& options) {
    RenderControl control;
    Result<RenderResult> result = render(lit.program, lit.scene, options, control);
    INFO((result ? "" : result.error().message));
    REQUIRE(result);
    return std::move(*result);
}

}  // namespace whittle::test
