// lanes.h — what many pixels draw for one sample, a pixel a lane: numbers, places in the filter, camera rays, ways to a sun's disc or a rectangle.
//
// Each function gives the bits of its single counterpart (Sampler::pair, FilterSampler::place, camera_ray, sample_light) on every instruction set; before
// them, aiming and lamps took two fifths of the time of a picture. Arrays begin at multiples of 64 bytes and have room for the next multiple of kLaneRoom.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "csg/base/vec.h"
#include "tracer/image/filter.h"
#include "tracer/light/rectangle.h"
#include "tracer/light/sampler.h"

namespace whittle::lanes {

inline constexpr std::size_t kRoom = 16, kMost = 256;
template <class T>
struct alignas(64) Row : std::array<T, kMost> {};

// Sampler::key() of pixels (x[k], y[k]).
void keys_of(std::uint64_t seed, const std::uint32_t* x, const std::uint32_t* y, std::size_t count, std::uint32_t* keys);

// 2^32 times Sampler(key, index, sequence).pair(draw) of each key and index. Sobol's pairs are drawn side by side, others one by one.
void pairs_of(const std::uint32_t* keys, const std::uint32_t* indices, std::size_t count, const PairOf& draw, std::uint32_t* u, std::uint32_t* v, Sequence sequence = {});

// FilterSampler::place() of one coordinate: offsets and weights.
void places_of(const FilterSampler::Table& table, const std::uint32_t* u, std::size_t count, double* offsets, double* weights);

// Unit vectors along middle + x across + y up.
struct Directions {
    double *x, *y, *z;
};
struct Window {
    Vec3 middle, across, up;
    double scale;  // of across and up
};
void through_window(const Window& window, const double* x, const double* y, std::size_t count, const Directions& out);

// The same through a lens with a disc for an aperture: rays of the eye's window go in, those through places of the disc come out, whose origins are `from`.
struct DiscLens {
    Vec3 eye, right, up, forward;
    double radius, focus;
};
void through_disc(const DiscLens& lens, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, const Directions& from, const Directions& rays);

// From places to points on a lamp (rectangle.h): places go in, ways come out. Solid angle 0: none.
void on_rectangle(const RectangleSides& sides, const Directions& places, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, double* solid_angles);

// ShadingFrame(axis).to_world(on_cap(., one_minus_cos)).
void in_cap(Vec3 axis, double one_minus_cos, const std::uint32_t* u, const std::uint32_t* v, std::size_t count, const Directions& out);

}  // namespace whittle::lanes
