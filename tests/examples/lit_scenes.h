// lit_scenes.h — a scene file compiled and ready to be drawn.
#pragma once

#include <memory>
#include <string>

#include "tests/examples/scenes.h"
#include "tracer/light/render.h"

namespace whittle::test {

struct LitScene {
    std::shared_ptr<const ReadScene> read;  // `scene` points into it
    std::shared_ptr<const Program> program;
    RenderScene scene;
};

// Requires (Catch): the file can be compiled. Pictures of surroundings are a small grey one: reading files is tested with the program.
LitScene lit_scene(const std::string& path);

// The picture, whatever integrator; fails the test where there is none.
RenderResult drawn(const LitScene& lit, const RenderOptions& options);

}  // namespace whittle::test
