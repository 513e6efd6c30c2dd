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
bool EdgeFinder::stepped(const Hit& a, const Hit& b) const {
    constexpr double kMostPixels = 6;
    const double pixel = 2 * stage_.lens.half_height / stage_.options.height * (stage_.lens.orthographic ? 1 : std::min(a.end.t, b.end.t));
    const Vec3 across = b.point - a.point;
    return std::min(std::abs(glm::dot(across, a.end.normal)), std::abs(glm::dot(across, b.end.normal))) > kMostPixels * pixel;
}

bool EdgeFinder::differ(std::size_t i) const {
    if (!first_.met[i] || !second_.met[i]) return first_.met[i] != second_.met[i];
    const Hit &a = first_.hits[i], &b = second_.hits[i];
    if (stepped(a, b)) return true;
    return a.end.surface != b.end.surface && glm::dot(a.end.normal, b.end.normal) < kFlatCosine;
}

void EdgeFinder::look(const Vec2* places, int count, Vec2 offset, Seen& seen) {
    for (int i = 0; i < count; ++i) rays_[static_cast<std::size_t>(i)] = picture_ray(stage_, places[i].x + offset.x, places[i].y + offset.y);
    first_hits(*stage_.program, rays_.data(), count, std::numeric_limits<double>::infinity(), scratch_, seen.hits.data(), seen.met.data());
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
