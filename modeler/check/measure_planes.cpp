// measure_planes.cpp — one line through the middle of each column of cells; within a column nothing changes across, so the sums are the integrals.
#include <cmath>
#include <limits>

#include "modeler/check/measure_methods.h"
#include "modeler/check/parallel_lines.h"

namespace whittle {

namespace {

struct ColumnSums {
    ChordSums chords;
    double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();

    ColumnSums& operator+=(const ColumnSums& o) {
        chords += o.chords;
        lo = std::min(lo, o.lo);
        hi = std::max(hi, o.hi);
        return *this;
    }
};

std::uint64_t cells(const std::vector<double>& planes) { return planes.size() < 2 ? 0 : planes.size() - 1; }

// Diagonal entries of `second` for axes x, y, z.
void add_column(ColumnSums& sums, const Ray& ray, const Spans& spans, Vec3 origin, Vec3 width) {
    ChordSums chords;
    add_chords(chords, ray, spans, origin);
    double across = 1;
    for (int i = 0; i < 3; ++i)
        if (ray.direction[i] == 0) across *= width[i];
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        if (ray.direction[axis] == 0) chords.second[i] += chords.volume * width[axis] * width[axis] / 12;
        if (ray.direction[axis] != 0 && !spans.empty() && !chords.unbounded) {
            sums.lo = std::min(sums.lo, ray.origin[axis] + spans.front().in->t);
            sums.hi = std::max(sums.hi, ray.origin[axis] + spans.back().out->t);
        }
    }
    sums.chords += chords.scaled(across);
}

ColumnSums sum_columns(const MeasureJob& job, const AxisPlanes& planes, std::size_t axis, EngineCounters& counters) {
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    const std::uint64_t wide = cells(planes[i]);
    const Vec3 origin = job.center();
    // Far enough outside, and a whole coordinate where that is possible: t of a plane is then a difference of doubles near each other.
    const int along = static_cast<int>(axis);
    const double start = std::floor(job.bounds.lo[along] - 1);
    return sum_over_lines<ColumnSums>(wide * cells(planes[j]), job.options.cancel, counters, [&](std::uint64_t k, LineScratch& scratch, ColumnSums& sums) {
        const double i0 = planes[i][k % wide], i1 = planes[i][k % wide + 1];
        const double j0 = planes[j][k / wide], j1 = planes[j][k / wide + 1];
        Ray ray;
        Vec3 width(0);
        width[static_cast<int>(i)] = i1 - i0;
        width[static_cast<int>(j)] = j1 - j0;
        ray.origin[static_cast<int>(i)] = i0 + (i1 - i0) / 2;
        ray.origin[static_cast<int>(j)] = j0 + (j1 - j0) / 2;
        ray.origin[along] = start;
        ray.direction = Vec3(0);
        ray.direction[along] = 1;
        all_spans(job.program, ray, scratch.engine, scratch.spans);
        add_column(sums, ray, scratch.spans, origin, width);
    });
}

}  // namespace

std::uint64_t lines_of_planes(const AxisPlanes& planes) {
    const std::uint64_t x = cells(planes[0]), y = cells(planes[1]), z = cells(planes[2]);
    return x * y + y * z + z * x;
}

Result<Measurement> measure_by_planes(const MeasureJob& job, const AxisPlanes& planes) {
    Measurement m;
    m.method = "planes";
    m.lines = lines_of_planes(planes);
    std::array<ColumnSums, 3> by_axis;
    for (std::size_t axis = 0; axis < 3; ++axis) by_axis[axis] = sum_columns(job, planes, axis, m.counters);
    ChordSums sums = by_axis[2].chords;
    if (sums.unbounded) return fail(Fault::kScene, "the solid is unbounded: it has no volume to measure");
    sums.area = by_axis[0].chords.area + by_axis[1].chords.area + by_axis[2].chords.area;
    set_values(m, sums, job.center());

    // A plane's coordinate is good to `shift`: rounding, and planes that were merged. Sums of n terms lose n units of the last place.
    const Vec3 size = job.bounds.hi - job.bounds.lo;
    const double extent = std::max({size.x, size.y, size.z}), reach = extent + glm::length(job.center());
    const double shift = kPlaneMerge * reach;
    const double loss = static_cast<double>(m.lines) * std::numeric_limits<double>::epsilon();
    m.volume.error = sums.slack + shift * sums.area + loss * sums.volume;
    m.area.error = shift * static_cast<double>(m.lines) * extent + loss * sums.area;
    for (Measured& c : m.centroid) c.error = sums.volume > 0 ? 2 * extent * m.volume.error / sums.volume + shift : 0;
    for (Measured& i : m.inertia) i.error = 8 * extent * extent * m.volume.error;
    for (std::size_t i = 0; i < 3; ++i) {
        m.lo[i] = {by_axis[i].lo, shift, ErrorKind::kBound};
        m.hi[i] = {by_axis[i].hi, shift, ErrorKind::kBound};
    }
    return m;
}

}  // namespace whittle
