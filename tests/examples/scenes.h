// scenes.h — a scene file as tests need it: text, solid, messages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "csg/eval/canonicalise.h"
#include "csg/eval/evaluate.h"

namespace whittle::test {

struct ReadScene {
    std::vector<std::string> messages;  // warnings and errors as the program prints them
    Canonical canonical;
    std::vector<Light> lights;
    std::optional<Camera> camera;
    bool stopped = false;
};

// Reads and canonicalises; `definitions` as -D gives them.
ReadScene read_scene(const std::string& path, const std::vector<std::string>& definitions = {}, Curves curves = Curves::kAuto);

std::string text_of(const std::string& path);

// The .scad files of a folder, sorted by name.
std::vector<std::string> scenes_in(const std::string& folder);

}  // namespace whittle::test
