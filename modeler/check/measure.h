// measure.h — volume, area, centroid, inertia and bounds of a solid, from exact spans, each with its error.
//
// A line's chord through the solid is exact, so an integral over the solid is an integral of chords over a plane. Two methods:
//  - "planes": every face lies in an axis plane. One line through the middle of each cell of the arrangement gives the integrals exactly, up to
//    rounding; errors are of kind "bound".
//  - "lines": independent randomisations, each of three orthogonal directions in a random rotation, with a randomly shifted grid of lines
//    along each. Chords give volume and moments; a crossing with unit normal n counts |n.d| towards the area, since
//    |n.d1|^2 + |n.d2|^2 + |n.d3|^2 = 1 and a surface element projects to |n.d| of itself. Every randomisation is unbiased, so their spread gives
//    the error: Student's t at 99 %, kind "ci99".
// The number of lines is fixed before any result is seen (a stopping rule on results would bias the interval) and does not depend on threads or time.
//
// Source: Kieu, Three lectures on systematic geometric sampling (1997); Santalo, Integral Geometry and Geometric Probability (1976), I.4.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>

#include "csg/base/result.h"
#include "csg/base/vec.h"
#include "csg/solid/solid.h"
#include "tracer/engine/engine.h"

namespace whittle {

// kBound: |value - truth| <= error, always. kConfidence99: so in 99 of 100 randomisations.
enum class ErrorKind { kBound, kConfidence99 };

// "bound" or "ci99".
const char* name_of(ErrorKind kind);

struct Measured {
    double value = 0;
    double error = 0;
    ErrorKind kind = ErrorKind::kBound;
};

struct MeasureOptions {
    std::uint64_t lines = 0;  // 0: as many as the scene's cost allows in about a second, by a count of work that no clock enters
    std::uint64_t seed = 0;
    bool allow_exact = true;  // false: "lines" always (tests compare the two)
    const std::atomic<bool>* cancel = nullptr;
};

struct Measurement {
    Measured volume, area;               // mm^3, mm^2
    std::array<Measured, 3> centroid;    // of the volume; 0 with infinite error where the solid is empty
    std::array<Measured, 9> inertia;     // row-major 3x3 about the centroid, unit density, mm^5
    std::array<Measured, 3> lo, hi;      // bounds; an empty solid has lo > hi as Bounds has
    std::uint64_t lines = 0;             // shot, bounds included
    std::uint64_t seed = 0;
    std::string method;                  // "planes" or "lines"
    EngineCounters counters;
};

// `program` is compile(solid). Same bytes for the same solid, options and any number of threads.
// Fails with kScene where the solid is unbounded, with kInterrupted where `cancel` became true.
Result<Measurement> measure(const Solid& solid, const Program& program, const MeasureOptions& options = {});

}  // namespace whittle
