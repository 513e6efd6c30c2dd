// scenes.cpp — the scenes, built straight from shapes.
#include "bench/scenes.h"

#include <random>

namespace whittle::bench {

namespace {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double between(double a, double b) { return a + (b - a) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
    Vec3 point(double half) {
        const double x = between(-half, half), y = between(-half, half), z = between(-half, half);
        return {x, y, z};
    }
    Vec3 direction() {
        while (true) {
            const Vec3 v = point(1);
            const double l = glm::length(v);
            if (l > 0.1 && l <= 1) return v / l;
        }
    }

private:
    std::mt19937_64 engine_;
};

NodeId box(SolidBuilder& b, double half) { return b.shape(shape::Box{Vec3(-half), Vec3(half)}); }
NodeId pin(SolidBuilder& b, double r, double half) { return b.shape(shape::Frustum{-half, half, r, r}); }
Use placed(NodeId node, const Placement& placement) { return {node, kNoLabel, 0, placement}; }
Use at(NodeId node, const Vec3& where) { return placed(node, Placement::translation(where)); }
Use here(NodeId node) { return placed(node, Placement()); }

// z goes to `axis`, an orthonormal frame around it.
Placement along(const Vec3& axis, const Vec3& where) {
    const Vec3 side = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0))), other = glm::cross(axis, side);
    return {{side.x, other.x, axis.x, where.x, side.y, other.y, axis.y, where.y, side.z, other.z, axis.z, where.z}};
}

Solid drilled_box() {
    SolidBuilder b;
    const NodeId drill = pin(b, 0.75, 1.1);
    const Placement to_x{{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0}}, to_y{{0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0}};
    return b.finish(here(b.combine(
        SetOp::kDifference, {here(box(b, 1)), here(b.shape(shape::Ellipsoid{Vec3(1.2)})), placed(drill, to_x), placed(drill, to_y), here(drill)})));
}

Solid drilled_plate() {
    SolidBuilder b;
    const NodeId hole = b.shape(shape::Frustum{-0.6, 0.2, 0.3, 0.3}), bore = b.shape(shape::Frustum{0.2, 0.6, 0.42, 0.42});
    std::vector<Use> parts{here(b.shape(shape::Box{Vec3(-5, -5, -0.5), Vec3(5, 5, 0.5)}))};
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j)
            for (const NodeId cutter : {hole, bore}) parts.push_back(at(cutter, {i - 4.5, j - 4.5, 0}));
    return b.finish(here(b.combine(SetOp::kDifference, std::move(parts))));
}

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

Solid ball_cloud() {
    SolidBuilder b;
    return b.finish(here(union_of(b, balls_of("S4"))));
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

Solid menger_sponge() {
    SolidBuilder b;
    std::vector<Use> parts{here(box(b, 1))};
    for (int level = 1, n = 3; level <= 4; ++level, n *= 3)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                bool open = i % 3 == 1 && j % 3 == 1;
                for (int x = i / 3, y = j / 3, k = 1; k < level; ++k, x /= 3, y /= 3) open = open && !(x % 3 == 1 && y % 3 == 1);
                if (!open) continue;
                const auto edge = [n](int k) { return (2.0 * k * (81 / n) - 81) / 81; };
                for (int axis = 0; axis < 3; ++axis) {
                    Vec3 lo(-1.001), hi(1.001);
                    lo[(axis + 1) % 3] = edge(i), hi[(axis + 1) % 3] = edge(i + 1);
                    lo[(axis + 2) % 3] = edge(j), hi[(axis + 2) % 3] = edge(j + 1);
                    parts.push_back(here(b.shape(shape::Box{lo, hi})));
                }
            }
    return b.finish(here(b.combine(SetOp::kDifference, std::move(parts))));
}

}  // namespace

const std::vector<std::string>& scene_names() {
    static const std::vector<std::string> names{"S1", "S2", "S3", "S4", "S5", "S6"};
    return names;
}

std::vector<Ball> balls_of(const std::string& name) { return name == "S4" ? random_balls(4, 100000, 0.005, 0.01) : std::vector<Ball>{}; }

BenchScene make_scene(const std::string& name) {
    const Bounds unit{Vec3(-1), Vec3(1)};
    if (name == "S1") return {name, "box less ball less three drills", drilled_box(), unit};
    if (name == "S2") return {name, "plate less 100 counterbored holes", drilled_plate(), {Vec3(-5, -5, -0.5), Vec3(5, 5, 0.5)}, 5.75, {0.35, -0.9, 1.3}};
    if (name == "S3") return {name, "1000 balls in a box less 200 pins", pinned_balls(), {Vec3(-0.9), Vec3(0.9)}, 1.55};
    if (name == "S4") return {name, "100,000 balls", ball_cloud(), unit};
    if (name == "S5") return {name, "random tree, 512 leaves", deep_tree(), unit, 1.6};
    return {name, "Menger sponge, level 4", menger_sponge(), unit};
}

}  // namespace whittle::bench
