// measure_bounds.cpp — the farthest points of a solid along the axes: a grid of lines, then a pattern search around the best.
//
// What is found is in the solid and what the box says is outside or on it, so the truth lies between: the error is a bound whatever the search does.
// Source: Hooke and Jeeves, Direct search solution of numerical and statistical problems (1961).
#include <cmath>
#include <limits>

#include "modeler/check/measure_methods.h"
#include "modeler/check/parallel_lines.h"

namespace whittle {

namespace {

constexpr int kGrid = 32;          // lines along each side of the first grid
constexpr int kStarts = 3;         // best grid lines that are refined
constexpr int kHalvings = 48;      // of the pattern's step: below the last place of its coordinates
constexpr int kRounds = 1000;      // of the pattern in all: along a narrow ridge that runs askew it would otherwise climb by its least step

// Finds the extreme of the solid along one axis, towards +axis (sign 1) or -axis (sign -1).
class ExtremeSearch {
public:
    ExtremeSearch(const MeasureJob& job, int axis, double sign) : job_(job), axis_(axis), i_((axis + 1) % 3), j_((axis + 2) % 3), sign_(sign) {
        const Bounds& b = job.bounds;
        outer_ = sign > 0 ? b.hi[axis] : b.lo[axis];
        start_ = outer_ + sign * (b.hi[axis] - b.lo[axis]) / 4;
        step_ = Vec2(b.hi[i_] - b.lo[i_], b.hi[j_] - b.lo[j_]) / static_cast<double>(kGrid);
    }

    Measured run(LineScratch& scratch, std::uint64_t& lines) {
        std::array<Best, kStarts> best;
        for (int k = 0; k < kGrid * kGrid; ++k) {
            const Vec2 at = Vec2(job_.bounds.lo[i_], job_.bounds.lo[j_]) + step_ * Vec2(k % kGrid + 0.5, k / kGrid + 0.5);
            offer(best, {probe(at, scratch), at});
        }
        for (Best& b : best) refine(b, scratch);
        double reach = -std::numeric_limits<double>::infinity();
        for (const Best& b : best) reach = std::max(reach, b.reach);
        lines += lines_;
        if (!std::isfinite(reach)) return {outer_, std::numeric_limits<double>::infinity(), ErrorKind::kBound};
        const double found = sign_ * reach;
        return {found, std::fabs(outer_ - found) + error_, ErrorKind::kBound};
    }

private:
    struct Best {
        double reach = -std::numeric_limits<double>::infinity();  // sign times the coordinate
        Vec2 at{0};
    };

    static void offer(std::array<Best, kStarts>& best, Best candidate) {
        for (Best& b : best)
            if (candidate.reach > b.reach) std::swap(b, candidate);
    }

    double probe(Vec2 at, LineScratch& scratch) {
        ++lines_;
        Ray ray;
        ray.origin[axis_] = start_;
        ray.origin[i_] = at.x;
        ray.origin[j_] = at.y;
        ray.direction = Vec3(0);
        ray.direction[axis_] = -sign_;
        Hit hit;
        if (!first_hit(job_.program, ray, std::numeric_limits<double>::infinity(), scratch.engine, hit)) return -std::numeric_limits<double>::infinity();
        error_ = std::max(error_, hit.end.t_error);
        return sign_ * (start_ - sign_ * hit.end.t);
    }

    void refine(Best& best, LineScratch& scratch) {
        if (!std::isfinite(best.reach)) return;
        Vec2 step = step_ / 2.0;
        for (int halving = 0, round = 0; halving < kHalvings && round < kRounds && best.reach < sign_ * outer_; ++round) {
            const Best before = best;
            for (int k = 0; k < 9; ++k) {
                const Vec2 at = before.at + step * Vec2(k % 3 - 1, k / 3 - 1);
                const double reach = k == 4 ? best.reach : probe(at, scratch);
                if (reach > best.reach) best = {reach, at};
            }
            const bool climbs = best.reach > before.reach + error_;  // less is rounding: a flat side is a little higher somewhere for ever
            if (climbs && halving == 0) continue;
            step *= climbs ? 2 : 0.5;
            halving += climbs ? -1 : 1;
        }
    }

    const MeasureJob& job_;
    int axis_, i_, j_;
    double sign_, outer_ = 0, start_ = 0, error_ = 0;
    Vec2 step_{0};
    std::uint64_t lines_ = 0;
};

}  // namespace

void measure_bounds(const MeasureJob& job, Measurement& measurement) {
    std::array<LineScratch, 6> scratch;
    std::array<std::uint64_t, 6> lines{};
    tbb::parallel_for(std::size_t{0}, std::size_t{6}, [&](std::size_t side) {
        if (job.cancelled()) return;
        Measured& out = side < 3 ? measurement.lo[side] : measurement.hi[side - 3];
        out = ExtremeSearch(job, static_cast<int>(side % 3), side < 3 ? -1 : 1).run(scratch[side], lines[side]);
    });
    for (std::size_t side = 0; side < 6; ++side) {
        measurement.lines += lines[side];
        measurement.counters += scratch[side].engine.counters;
    }
}

}  // namespace whittle
