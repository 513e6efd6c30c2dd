// measure.cpp — chooses the method.
#include "modeler/check/measure.h"

#include <cmath>
#include <limits>

#include "modeler/check/measure_methods.h"

namespace whittle {

namespace {

// More lines than this and the exact arrangement is no longer the quick way.
constexpr std::uint64_t kMostPlaneLines = 4'000'000;
constexpr std::size_t kMostPlanes = 4'000;

bool finite(const Bounds& b) {
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(b.lo[i]) || !std::isfinite(b.hi[i])) return false;
    return true;
}

Measurement nothing() {
    Measurement m;
    m.method = "planes";
    for (Measured& c : m.centroid) c.error = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        m.lo[i].value = Bounds{}.lo[static_cast<int>(i)];
        m.hi[i].value = Bounds{}.hi[static_cast<int>(i)];
    }
    return m;
}

}  // namespace

const char* name_of(ErrorKind kind) { return kind == ErrorKind::kBound ? "bound" : "ci99"; }

void set_values(Measurement& measurement, const ChordSums& sums, Vec3 origin) {
    const double v = sums.volume;
    measurement.volume.value = v;
    measurement.area.value = sums.area;
    const Vec3 c = v > 0 ? sums.first / v : Vec3(0);
    for (std::size_t i = 0; i < 3; ++i) measurement.centroid[i].value = origin[static_cast<int>(i)] + c[static_cast<int>(i)];
    const double xx = sums.second[0] - v * c.x * c.x, yy = sums.second[1] - v * c.y * c.y, zz = sums.second[2] - v * c.z * c.z;
    const double xy = sums.second[3] - v * c.x * c.y, xz = sums.second[4] - v * c.x * c.z, yz = sums.second[5] - v * c.y * c.z;
    const std::array<double, 9> inertia{yy + zz, -xy, -xz, -xy, xx + zz, -yz, -xz, -yz, xx + yy};
    for (std::size_t i = 0; i < 9; ++i) measurement.inertia[i].value = inertia[i];
}

Result<Measurement> measure(const Solid& solid, const Program& program, const MeasureOptions& options) {
    const Bounds bounds = program_bounds(program);
    if (bounds.empty()) return nothing();
    if (!finite(bounds)) return fail(Fault::kScene, "the solid is unbounded: it has no volume to measure");
    const MeasureJob job{solid, program, bounds, options};
    Result<Measurement> measurement;
    const std::optional<AxisPlanes> planes = options.allow_exact ? axis_planes(solid, kMostPlanes) : std::nullopt;
    if (planes && lines_of_planes(*planes) <= kMostPlaneLines) {
        measurement = measure_by_planes(job, *planes);
    } else {
        measurement = measure_by_lines(job);
        if (measurement) measure_bounds(job, *measurement);
    }
    if (job.cancelled()) return fail(Fault::kInterrupted, "interrupted");
    if (measurement && measurement->volume.value == 0 && measurement->method == "planes") {
        Measurement empty = nothing();
        empty.lines = measurement->lines;
        empty.seed = options.seed;
        return empty;
    }
    if (measurement) measurement->seed = options.seed;
    return measurement;
}

}  // namespace whittle
