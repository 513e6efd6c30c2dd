// series.cpp — families of scenes: one shape of solid in several sizes.
#include <cmath>

#include "bench/scene_parts.h"

namespace whittle::bench {

namespace {

// Is the cell (i, j) of level k the middle of its nine, and no larger cell around it?
bool first_open_at(int i, int j, int level) {
    if (i % 3 != 1 || j % 3 != 1) return false;
    for (int k = 1; k < level; ++k) {
        i /= 3, j /= 3;
        if (i % 3 == 1 && j % 3 == 1) return false;
    }
    return true;
}

// A ball with waves on it: `rings` of 2 `rings` points and two poles.
std::shared_ptr<const FacetList> wavy_ball(int rings) {
    auto list = std::make_shared<FacetList>();
    const int around = 2 * rings;
    constexpr double kPi = 3.14159265358979323846;
    list->points.push_back({0, 0, 1});
    for (int i = 1; i <= rings; ++i)
        for (int j = 0; j < around; ++j) {
            const double latitude = kPi * i / (rings + 1), longitude = 2 * kPi * j / around;
            const double r = 1 + 0.05 * std::sin(8 * longitude) * std::sin(6 * latitude) * std::sin(latitude);
            list->points.push_back(r * Vec3(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude), std::cos(latitude)));
        }
    list->points.push_back({0, 0, -1});
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(1 + (i - 1) * around + j % around); };
    const auto last = static_cast<std::uint32_t>(list->points.size() - 1);
    for (int j = 0; j < around; ++j) {
        list->facets.push_back({0, at(1, j), at(1, j + 1)});
        list->facets.push_back({last, at(rings, j + 1), at(rings, j)});
        for (int i = 1; i < rings; ++i) {
            list->facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            list->facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return list;
}

}  // namespace

BenchScene ball_scene() {
    BenchScene scene;
    scene.name = "ball", scene.what = "a ball";
    SolidBuilder b;
    const NodeId root = b.shape(shape::Ellipsoid{Vec3(1)});
    scene.solid = b.finish(here(root));
    scene.box = {Vec3(-1), Vec3(1)};
    scene.meshable = true;
    return scene;
}

BenchScene menger_scene(int level) {
    SolidBuilder b;
    std::vector<Use> parts{here(box(b, 1))};
    const int cells = static_cast<int>(std::lround(std::pow(3, level)));
    for (int k = 1, n = 3; k <= level; ++k, n *= 3)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                if (!first_open_at(i, j, k)) continue;
                const auto edge = [&](int m) { return (2.0 * m * (cells / n) - cells) / cells; };
                for (int axis = 0; axis < 3; ++axis) {
                    Vec3 lo(-1.001), hi(1.001);
                    lo[(axis + 1) % 3] = edge(i), hi[(axis + 1) % 3] = edge(i + 1);
                    lo[(axis + 2) % 3] = edge(j), hi[(axis + 2) % 3] = edge(j + 1);
                    parts.push_back(here(b.shape(shape::Box{lo, hi})));
                }
            }
    BenchScene scene;
    scene.what = "Menger sponge, level " + std::to_string(level);
    scene.primitives = static_cast<double>(parts.size());
    scene.solid = b.finish(here(b.combine(SetOp::kDifference, std::move(parts))));
    scene.box = {Vec3(-1), Vec3(1)};
    scene.sponge_level = level;
    return scene;
}

BenchScene plate_scene(int holes) {
    const int side = static_cast<int>(std::ceil(std::sqrt(holes)));
    const double half = 0.5 * side;
    SolidBuilder b;
    const NodeId hole = b.shape(shape::Frustum{-0.6, 0.2, 0.3, 0.3}), bore = b.shape(shape::Frustum{0.2, 0.6, 0.42, 0.42});
    std::vector<Use> parts{here(b.shape(shape::Box{Vec3(-half, -half, -0.5), Vec3(half, half, 0.5)}))};
    for (int k = 0; k < holes; ++k)
        for (const NodeId cutter : {hole, bore}) parts.push_back(at(cutter, {k / side + 0.5 - half, k % side + 0.5 - half, 0}));
    BenchScene scene;
    scene.what = "plate less " + std::to_string(holes) + " counterbored holes";
    scene.primitives = static_cast<double>(parts.size());
    scene.solid = b.finish(here(b.combine(SetOp::kDifference, std::move(parts))));
    scene.box = {Vec3(-half, -half, -0.5), Vec3(half, half, 0.5)};
    scene.radius = 1.15 * half;
    scene.from = {0.35, -0.9, 1.3};
    scene.meshable = holes <= 400;
    return scene;
}

BenchScene balls_scene(int count) {
    const double size = std::cbrt(1e5 / count);
    BenchScene scene;
    scene.what = std::to_string(count) + " balls";
    scene.balls = random_balls(4, count, 0.005 * size, 0.01 * size);
    scene.primitives = count;
    SolidBuilder b;
    const NodeId root = union_of(b, scene.balls);
    scene.solid = b.finish(here(root));
    scene.box = {Vec3(-1), Vec3(1)};
    return scene;
}

// In a cube of cells, each turned its own way: a part fills a ball of its cell.
BenchScene instances_scene(int count) {
    const int side = static_cast<int>(std::ceil(std::cbrt(count)));
    const double cell = 2.0 / side, scale = cell / (2 * std::sqrt(3.0));
    BenchScene scene;
    scene.part = std::make_shared<const BenchScene>(*make_scene("S1"));
    SolidBuilder b;
    const NodeId part = drilled_box(b);
    Random random(6);
    std::vector<Use> parts;
    for (int k = 0; k < count; ++k) {
        const Vec3 where = (Vec3(k % side, k / side % side, k / side / side) + 0.5) * cell - 1.0;
        Placement placement = along(random.direction(), where);
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column) placement.m[4 * row + column] *= scale;
        parts.push_back(placed(part, placement));
        scene.placements.push_back(placement);
    }
    scene.what = std::to_string(count) + " turned instances of S1";
    scene.primitives = count;
    scene.solid = b.finish(here(b.combine(SetOp::kUnion, std::move(parts))));
    scene.box = {Vec3(-1), Vec3(1)};
    return scene;
}

BenchScene mesh_scene(int triangles) {
    BenchScene scene;
    scene.facets = wavy_ball(static_cast<int>(std::lround(std::sqrt(triangles / 4.0))));
    scene.what = "a mesh of " + std::to_string(scene.facets->facets.size()) + " triangles";
    scene.primitives = static_cast<double>(scene.facets->facets.size());
    SolidBuilder b;
    const NodeId root = b.shape(shape::Polyhedron{scene.facets});
    scene.solid = b.finish(here(root));
    scene.box = {Vec3(-1.05), Vec3(1.05)};
    scene.radius = 1.1;
    return scene;
}

}  // namespace whittle::bench
