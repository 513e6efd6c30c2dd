#include "tracer/light/edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/light/planes.h"

namespace whittle {

namespace {

// Faces that meet more flatly than this (15 degrees) are drawn as one.
constexpr double kFlatCosine = 0.9659258262890683;

}  // namespace

// Is one of the two far in front of the other's tangent plane, seen in pixels?
bool EdgeFinder::stepped(std::size_t i) const {
    constexpr double kMostPixels = 6;
    const double pixel = 2 * stage_.lens.half_height / stage_.options.height * (stage_.lens.orthographic ? 1 : std::min(first_.t[i], second_.t[i]));
    const Vec3 across = second_.point_of(i) - first_.point_of(i);
    return std::min(std::abs(glm::dot(across, first_.normal_of(i))), std::abs(glm::dot(across, second_.normal_of(i)))) > kMostPixels * pixel;
}

bool EdgeFinder::differ(std::size_t i) const {
    if (!first_.met(i) || !second_.met(i)) return first_.met(i) != second_.met(i);
    if (stepped(i)) return true;
    return first_.surface[i] != second_.surface[i] && glm::dot(first_.normal_of(i), second_.normal_of(i)) < kFlatCosine;
}

void EdgeFinder::look(const Vec2* places, int count, Vec2 offset, Seen& seen) {
    const auto n = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < n; ++i) {
        const Ray ray = picture_ray(stage_, places[i].x + offset.x, places[i].y + offset.y);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            origin_[axis][i] = ray.origin[static_cast<int>(axis)];
            direction_[axis][i] = ray.direction[static_cast<int>(axis)];
        }
    }
    first_hits(*stage_.program, {{origin_[0].data(), origin_[1].data(), origin_[2].data()}, {direction_[0].data(), direction_[1].data(), direction_[2].data()}}, count,
               std::numeric_limits<double>::infinity(), scratch_,
               {seen.t.data(), seen.t_error.data(), {seen.normal[0].data(), seen.normal[1].data(), seen.normal[2].data()}, seen.surface.data(), seen.use.data()});
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < n; ++i) seen.point[axis][i] = origin_[axis][i] + seen.t[i] * direction_[axis][i];
}

void EdgeFinder::find(const Vec2* places, int count, bool* edge) {
    std::fill_n(edge, count, false);
    for (const double slope : {0.5, -0.5}) {
        look(places, count, {-0.5, -slope}, first_);
        look(places, count, {0.5, slope}, second_);
        for (int i = 0; i < count; ++i) edge[i] = edge[i] || differ(static_cast<std::size_t>(i));
    }
}

}  // namespace whittle
