// scenes.cpp — the scenes of the prototypes, built straight from shapes; the families are in series.cpp.
#include "bench/scenes.h"

#include <algorithm>
#include <charconv>

#include "bench/scene_parts.h"

namespace whittle::bench {

std::vector<Ball> random_balls(std::uint64_t seed, int count, double least, double most) {
    Random random(seed);
    std::vector<Ball> balls;
    for (int i = 0; i < count; ++i) {
        const Vec3 centre = random.point(1);
        balls.push_back({centre, random.between(least, most)});
    }
    return balls;
}

NodeId union_of(SolidBuilder& b, const std::vector<Ball>& balls) {
    std::vector<Use> parts;
    for (const Ball& ball : balls) parts.push_back(at(b.shape(shape::Ellipsoid{Vec3(ball.radius)}), ball.centre));
    return b.combine(SetOp::kUnion, std::move(parts));
}

NodeId drilled_box(SolidBuilder& b) {
    const NodeId drill = pin(b, 0.75, 1.1);
    const Placement to_x{{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0}}, to_y{{0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0}};
    return b.combine(SetOp::kDifference, {here(box(b, 1)), here(b.shape(shape::Ellipsoid{Vec3(1.2)})), placed(drill, to_x), placed(drill, to_y), here(drill)});
}

namespace {

Solid pinned_balls() {
    SolidBuilder b;
    const NodeId cloud = union_of(b, random_balls(3, 1000, 0.05, 0.15));
    const NodeId body = b.combine(SetOp::kIntersection, {here(cloud), here(box(b, 0.9))});
    std::vector<Use> parts{here(body)};
    Random random(33);
    for (int i = 0; i < 200; ++i) {
        const Vec3 where = random.point(1);
        parts.push_back(placed(pin(b, 0.05, 1), along(random.direction(), where)));
    }
    return b.finish(here(b.combine(SetOp::kDifference, std::move(parts))));
}

Use random_leaf(SolidBuilder& b, Random& random) {
    const Vec3 where = random.point(0.5);
    const double kind = random.between(0, 1);
    if (kind < 0.4) return at(b.shape(shape::Ellipsoid{Vec3(random.between(0.7, 1.2))}), where);
    if (kind < 0.7) {
        const double x = random.between(0.6, 1), y = random.between(0.6, 1), z = random.between(0.6, 1);
        return at(b.shape(shape::Box{-Vec3(x, y, z), Vec3(x, y, z)}), where);
    }
    const double r = random.between(0.6, 1), half = random.between(0.7, 1.2);
    return placed(pin(b, r, half), along(random.direction(), where));
}

Use random_tree(SolidBuilder& b, Random& random, int depth) {
    if (depth == 9) return random_leaf(b, random);
    constexpr SetOp kOps[] = {SetOp::kUnion, SetOp::kDifference, SetOp::kIntersection};
    const Use left = random_tree(b, random, depth + 1), right = random_tree(b, random, depth + 1);
    return here(b.combine(kOps[depth % 3], {left, right}));
}

Solid deep_tree() {
    SolidBuilder b;
    Random random(5);
    const Use root = random_tree(b, random, 0);
    return b.finish(root);
}

// The number behind the letters of a name; 0 where there is none.
int number_in(const std::string& name, std::size_t letters) {
    int n = 0;
    const auto [end, fault] = std::from_chars(name.data() + letters, name.data() + name.size(), n);
    return fault == std::errc() && end == name.data() + name.size() ? n : 0;
}

struct Family {
    std::string letters;
    int least, most;
    BenchScene (*make)(int);
};
const std::vector<Family>& families() {
    static const std::vector<Family> list{{"menger", 1, 5, menger_scene},
                                          {"plate", 1, 250'000, plate_scene},
                                          {"balls", 1, 4'000'000, balls_scene},
                                          {"instances", 1, 4'000'000, instances_scene},
                                          {"mesh", 100, 8'000'000, mesh_scene}};
    return list;
}

}  // namespace

bool is_scene(const std::string& name) {
    if (name.size() == 2 && name[0] == 'S' && name[1] >= '1' && name[1] <= '6') return true;
    return std::any_of(families().begin(), families().end(), [&](const Family& f) {
        const int count = name.rfind(f.letters, 0) == 0 ? number_in(name, f.letters.size()) : 0;
        return count >= f.least && count <= f.most;
    });
}

std::optional<BenchScene> make_scene(const std::string& name) {
    const Bounds unit{Vec3(-1), Vec3(1)};
    BenchScene scene;
    if (name == "S1") {
        SolidBuilder b;
        const NodeId root = drilled_box(b);
        scene.solid = b.finish(here(root));
        scene.what = "box less ball less three drills", scene.box = unit, scene.primitives = 5, scene.meshable = true;
    } else if (name == "S2") {
        scene = plate_scene(100);
    } else if (name == "S3") {
        scene.solid = pinned_balls(), scene.what = "1000 balls in a box less 200 pins", scene.box = {Vec3(-0.9), Vec3(0.9)};
        scene.radius = 1.55, scene.primitives = 1201;
    } else if (name == "S4") {
        scene = balls_scene(100'000);
    } else if (name == "S5") {
        scene.solid = deep_tree(), scene.what = "random tree, 512 leaves", scene.box = unit;
        scene.radius = 1.6, scene.primitives = 512;
    } else if (name == "S6") {
        scene = menger_scene(4);
    } else {
        const auto family = std::find_if(families().begin(), families().end(), [&](const Family& f) { return name.rfind(f.letters, 0) == 0; });
        if (family == families().end()) return std::nullopt;
        const int count = number_in(name, family->letters.size());
        if (count < family->least || count > family->most) return std::nullopt;
        scene = family->make(count);
    }
    scene.name = name;
    return scene;
}

}  // namespace whittle::bench
