// The end of a run: the root, what a `!` leaves, lights, the view.
#include "csg/eval/builtin_module_parts.h"
#include "csg/eval/machine.h"

namespace whittle {

using namespace code;

void Machine::add_light(Light light) { scene_->lights.push_back(std::move(light)); }

void Machine::set_camera(Camera camera) {
    if (scene_->camera) warn(camera.place, "camera() was given before: the last one wins");
    scene_->camera = camera;
}

void Machine::finish(Scene& scene) {
    SceneNode root;
    root.what = scene::Group{"root"};
    root.children = pending_;
    root.place = {0, 1, 1};
    pending_.clear();
    scene.nodes.push_back(std::move(root));
    scene.root = static_cast<SceneNodeId>(scene.nodes.size() - 1);
    if (!roots_.empty()) keep_root(scene);
    read_view(scene);
}

// The first node marked with `!`, in the order of the tree, is all that is left, with the lights under it.
void Machine::keep_root(Scene& scene) {
    std::vector<SceneNodeId> open{scene.root};
    std::optional<SceneNodeId> first;
    std::size_t count = 0;
    while (!open.empty()) {
        const SceneNodeId id = open.back();
        open.pop_back();
        if (scene.nodes[id].modifiers & kRoot) {
            if (!first) first = id;
            ++count;
        }
        const ChildIds& children = scene.nodes[id].children;
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    if (!first) return;
    scene.nodes[scene.root].children = {*first};
    for (const Root& r : roots_) {
        if (r.node != *first) continue;
        if (count > 1) diagnostics_.add(Severity::kWarning, r.place, "More than one Root Modifier (!)");
        scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(r.end_light), scene.lights.end());
        scene.lights.erase(scene.lights.begin(), scene.lights.begin() + static_cast<std::ptrdiff_t>(r.first_light));
        break;
    }
}

void Machine::read_view(Scene& scene) {
    const auto assigned = [this](std::uint32_t which) {
        for (const Bind& b : program_.scopes[program_.files[0].body].binds)
            if (b.kind == BindKind::kDynamic && b.target == which) return true;
        return false;
    };
    Vec3 v{0};
    if (assigned(kVpr)) {
        if (read_vec3(cells_[kVpr], v, 0)) scene.view.rotation_deg = v;
        else diagnostics_.add(Severity::kWarning, {}, "Unable to convert $vpr=" + text_of(cells_[kVpr]) + " to a vec3 or vec2 of numbers");
    }
    if (assigned(kVpt)) {
        if (read_vec3(cells_[kVpt], v, 0)) scene.view.target = v;
        else diagnostics_.add(Severity::kWarning, {}, "Unable to convert $vpt=" + text_of(cells_[kVpt]) + " to a vec3 or vec2 of numbers");
    }
    double n = 0;
    if (assigned(kVpd)) {
        if (read_number(cells_[kVpd], n)) scene.view.distance = n;
        else diagnostics_.add(Severity::kWarning, {}, "Unable to convert $vpd=" + text_of(cells_[kVpd]) + " to a number");
    }
    if (assigned(kVpf)) {
        if (read_number(cells_[kVpf], n)) scene.view.fov_deg = n;
        else diagnostics_.add(Severity::kWarning, {}, "Unable to convert $vpf=" + text_of(cells_[kVpf]) + " to a number");
    }
}

}  // namespace whittle
