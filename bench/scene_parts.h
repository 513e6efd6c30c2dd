// scene_parts.h — what the scenes are put together from: numbers of a fixed seed, placements, unions. Internal to scenes.cpp and series.cpp.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "bench/scenes.h"

namespace whittle::bench {

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

inline NodeId box(SolidBuilder& b, double half) { return b.shape(shape::Box{Vec3(-half), Vec3(half)}); }
inline NodeId pin(SolidBuilder& b, double r, double half) { return b.shape(shape::Frustum{-half, half, r, r}); }
inline Use placed(NodeId node, const Placement& placement) { return {node, kNoLabel, 0, placement}; }
inline Use at(NodeId node, const Vec3& where) { return placed(node, Placement::translation(where)); }
inline Use here(NodeId node) { return placed(node, Placement()); }

// z goes to `axis`, an orthonormal frame around it.
inline Placement along(const Vec3& axis, const Vec3& where) {
    const Vec3 side = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0))), other = glm::cross(axis, side);
    return {{side.x, other.x, axis.x, where.x, side.y, other.y, axis.y, where.y, side.z, other.z, axis.z, where.z}};
}

std::vector<Ball> random_balls(std::uint64_t seed, int count, double least, double most);
NodeId union_of(SolidBuilder& b, const std::vector<Ball>& balls);
// A box less a ball less three drills: S1.
NodeId drilled_box(SolidBuilder& b);

// The families of series.cpp; `count` is what the name says.
BenchScene menger_scene(int level);
BenchScene plate_scene(int holes);
BenchScene balls_scene(int count);
BenchScene instances_scene(int count);
BenchScene mesh_scene(int triangles);

}  // namespace whittle::bench
