// measure_methods.h — the two methods of measure.h and the search for bounds; each fills its part of a Measurement.
#pragma once

#include <atomic>
#include <cstdint>

#include "modeler/check/axis_planes.h"
#include "modeler/check/chord_sums.h"
#include "modeler/check/measure.h"

namespace whittle {

// 99 % point (two-sided) of Student's distribution with kRandomisations - 1 = 15 degrees of freedom.
inline constexpr int kRandomisations = 16;
inline constexpr double kStudent99 = 2.9467128834752385;

// What both methods need.
struct MeasureJob {
    const Solid& solid;
    const Program& program;
    Bounds bounds;  // finite and outward
    const MeasureOptions& options;

    bool cancelled() const { return options.cancel && options.cancel->load(); }
    Vec3 center() const { return bounds.lo + (bounds.hi - bounds.lo) * 0.5; }
};

// Number of lines that the arrangement needs.
std::uint64_t lines_of_planes(const AxisPlanes& planes);

// Everything, bounds too, from one line a cell.
Result<Measurement> measure_by_planes(const MeasureJob& job, const AxisPlanes& planes);

// Everything but the bounds.
Result<Measurement> measure_by_lines(const MeasureJob& job);

// lo and hi: the farthest points that lines along the axes find, refined locally; the error reaches to the outward box.
void measure_bounds(const MeasureJob& job, Measurement& measurement);

// Mean of independent unbiased values, with its 99 % interval.
Measured mean_of(const std::array<double, kRandomisations>& values);

// Fills volume, area, centroid and inertia from integrals about `origin`. Errors are left alone.
void set_values(Measurement& measurement, const ChordSums& sums, Vec3 origin);

}  // namespace whittle
