// clip.cpp — see clip.h.
#include "modeler/cli/clip.h"

namespace whittle {

void clip_scene(Scene& scene, const std::vector<std::array<double, 4>>& clips) {
    if (clips.empty()) return;
    const auto add = [&scene](scene::What what, std::vector<SceneNodeId> children) {
        SceneNode node;
        node.what = std::move(what);
        node.children = std::move(children);
        scene.nodes.push_back(std::move(node));
        return static_cast<SceneNodeId>(scene.nodes.size() - 1);
    };
    std::vector<SceneNodeId> operands{scene.root};
    for (const auto& clip : clips) operands.push_back(add(scene::HalfSpace{{clip[0], clip[1], clip[2]}, clip[3]}, {}));
    const SceneNodeId cut = add(scene::Intersection{}, std::move(operands));
    scene.root = add(scene::Group{"group"}, {cut});
}

}  // namespace whittle
