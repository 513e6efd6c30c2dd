// ray_sets.h — rays to time: a camera's in tiles, and rays that have nothing in common.
#pragma once

#include "bench/scenes.h"
#include "csg/span/ray.h"
#include "tracer/light/camera.h"

namespace whittle::bench {

inline constexpr int kTile = 16;                // pixels of a tile's side
inline constexpr int kBatch = kTile * kTile;    // rays timed together

// The camera of the rays below; its picture is as wide as it is high, times the rays' width over their height.
Lens camera_lens(const BenchScene& scene);

// Ordered by tiles of 16 x 16 pixels and, in a tile, by blocks of 4 x 4: every subject gets the order that suits packets.
// Requires: width and height are multiples of 16.
std::vector<Ray> camera_rays(const BenchScene& scene, int width, int height);

// From uniform points of the scene's ball to uniform points of its box.
std::vector<Ray> incoherent_rays(const BenchScene& scene, int count);

}  // namespace whittle::bench
