// measure_lines.cpp — parallel lines in three orthogonal directions, sixteen independent randomisations.
//
// Across a direction the lines stand on a square grid with a random shift, the frame itself is turned at random. A chord grows from nothing like a square
// root at a smooth solid's outline, so its transform falls like |f|^-2 and the grid's error like 1/lines; at a polyhedron's faster. At 0.8 million lines
// the interval is 3e-5 of a ball's volume and 2e-6 of a box's; Owen-scrambled Sobol points gave 6e-5 and 3e-5.
// Source: Kendall, On the number of points of a given lattice in a random oval (1948); Kieu, Three lectures on systematic geometric sampling (1997).
#include <algorithm>
#include <cmath>
#include <limits>

#include "modeler/check/measure_methods.h"
#include "modeler/check/parallel_lines.h"
#include "modeler/check/sobol.h"  // mixed

namespace whittle {

namespace {

// Work that about a second allows, in units of a primitive's test; a line costs some of its own.
constexpr double kWorkBudget = 3e7;
constexpr double kWorkOfALine = 12;
// An edge of an outline costs every line that comes near; the engine's counter of tests does not see it.
constexpr double kWorkOfAnEdge = 0.1;
constexpr double kLeastLines = 256, kMostLines = 32768;  // of a direction of a randomisation

// A direction and the rectangle across it that the solid's box is seen in.
struct Sheet {
    Vec3 u, v, d, corner;  // a line starts at corner + x u + y v, 0 <= x, y < 1, along d
    double area = 0;
    std::uint64_t columns = 1, rows = 1;
    double shift_u = 0, shift_v = 0;

    std::uint64_t lines() const { return columns * rows; }
    Vec3 start(std::uint64_t k) const {
        const double x = (static_cast<double>(k % columns) + shift_u) / static_cast<double>(columns);
        return corner + x * u + (static_cast<double>(k / columns) + shift_v) / static_cast<double>(rows) * v;
    }
};

using Sheets = std::array<Sheet, 3>;

double uniform(std::uint64_t seed, std::uint64_t k) { return static_cast<double>(mixed(seed, k) >> 11) * 0x1p-53; }

// A rotation uniformly distributed over all rotations, by a unit quaternion (Shoemake 1992).
std::array<Vec3, 3> random_frame(std::uint64_t seed) {
    const double a = uniform(seed, 1), b = 2 * M_PI * uniform(seed, 2), c = 2 * M_PI * uniform(seed, 3);
    const double x = std::sqrt(1 - a) * std::sin(b), y = std::sqrt(1 - a) * std::cos(b), z = std::sqrt(a) * std::sin(c), w = std::sqrt(a) * std::cos(c);
    return {Vec3(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)),
            Vec3(2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)),
            Vec3(2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y))};
}

// About n lines a sheet, as many to the millimetre along u as along v.
Sheets make_sheets(const MeasureJob& job, std::uint64_t randomisation, double n) {
    const std::uint64_t seed = mixed(mixed(job.options.seed, 0x6D656173), randomisation);
    const std::array<Vec3, 3> axes = random_frame(seed);
    const Vec3 half = (job.bounds.hi - job.bounds.lo) * 0.5;
    // A little wider than the box, so that the rounding of a line's place cannot lose a sliver.
    const auto reach = [&](Vec3 a) { return glm::dot(glm::abs(a), half) * (1 + 0x1p-40); };
    Sheets sheets;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 u = axes[(k + 1) % 3], v = axes[(k + 2) % 3], d = axes[k];
        Sheet& s = sheets[k];
        s.u = 2 * reach(u) * u;
        s.v = 2 * reach(v) * v;
        s.d = d;
        s.corner = job.center() - reach(u) * u - reach(v) * v - 1.25 * reach(d) * d;
        s.area = 4 * reach(u) * reach(v);
        const double spacing = std::sqrt(s.area / n);
        s.columns = static_cast<std::uint64_t>(std::ceil(2 * reach(u) / spacing));
        s.rows = static_cast<std::uint64_t>(std::ceil(2 * reach(v) / spacing));
        s.shift_u = uniform(seed, 10 + k);
        s.shift_v = uniform(seed, 20 + k);
    }
    return sheets;
}

// Unbiased integrals about the box's centre, and how many lines they took.
struct SheetSums {
    ChordSums sums;
    std::uint64_t lines = 0;
};

SheetSums sum_sheets(const MeasureJob& job, std::uint64_t randomisation, double n, EngineCounters& counters) {
    const Sheets sheets = make_sheets(job, randomisation, n);
    const Vec3 origin = job.center();
    const auto line = [&](std::uint64_t i, LineScratch& scratch, ChordSums& sums) {
        std::size_t at = 0;
        while (i >= sheets[at].lines()) i -= sheets[at++].lines();
        Ray ray;
        ray.origin = sheets[at].start(i);
        ray.direction = sheets[at].d;
        all_spans(job.program, ray, scratch.engine, scratch.spans);
        ChordSums chords;
        add_chords(chords, ray, scratch.spans, origin);
        sums += chords.scaled(sheets[at].area / (3 * static_cast<double>(sheets[at].lines())));
    };
    SheetSums r;
    r.lines = sheets[0].lines() + sheets[1].lines() + sheets[2].lines();
    r.sums = sum_over_lines<ChordSums>(r.lines, job.options.cancel, counters, line);
    r.sums.area *= 3;  // the three directions add up to the area; each alone gives the volume
    return r;
}

// What a test of a shape costs on average: of facets a walk down their hierarchy, of anything else 1. All shapes weigh alike, since which of them a line
// tests is not counted. kWorkOfAStep: `measure` of the sum of a torus and an ellipsoid (80 pieces of some thousand facets) spent 1.7 us a test, a budget's
// unit is 0.07 us.
double work_of_a_test(const Solid& solid) {
    constexpr double kWorkOfAStep = 2.5;
    double work = 0, shapes = 0;
    for (NodeId id = 0; id < solid.node_count(); ++id)
        if (const auto* shape = std::get_if<Shape>(&solid.node(id))) {
            const auto* facets = std::get_if<shape::Polyhedron>(shape);
            work += facets ? kWorkOfAStep * std::log2(static_cast<double>(facets->mesh->facets.size()) + 2) : 1;
            ++shapes;
        }
    return shapes > 0 ? work / shapes : 1;
}

std::size_t outline_edges(const Solid& solid) {
    std::size_t edges = 0;
    for (NodeId id = 0; id < solid.node_count(); ++id)
        if (const auto* shape = std::get_if<Shape>(&solid.node(id)))
            if (const auto* polygon = std::get_if<shape::Polygon>(shape))
                for (const std::vector<Vec2>& contour : *polygon->contours) edges += contour.size();
    return edges;
}

// Lines of a sheet. The work of a line is counted on lines that enter no result.
double lines_of_sheet(const MeasureJob& job, EngineCounters& counters) {
    if (job.options.lines != 0) return std::max(1.0, static_cast<double>(job.options.lines) / (3 * kRandomisations));
    EngineCounters pilot;
    const SheetSums counted = sum_sheets(job, std::numeric_limits<std::uint64_t>::max(), kLeastLines, pilot);
    counters += pilot;
    const double work = kWorkOfALine + work_of_a_test(job.solid) * static_cast<double>(pilot.primitive_tests) / static_cast<double>(counted.lines) +
                        kWorkOfAnEdge * static_cast<double>(outline_edges(job.solid));
    return std::clamp(kWorkBudget / (work * 3 * kRandomisations), kLeastLines, kMostLines);
}

// Half width of the interval of the mean of values(randomisation).
template <class Values>
double half_width(const Values& values) {
    std::array<double, kRandomisations> list{};
    for (std::size_t r = 0; r < kRandomisations; ++r) list[r] = values(r);
    return mean_of(list).error;
}

// Centroid and inertia are no sums: their intervals are those of the sums they are locally linear in (the delta method).
void set_errors(Measurement& m, const std::array<ChordSums, kRandomisations>& parts, const ChordSums& mean) {
    const double v = mean.volume;
    const Vec3 c = v > 0 ? mean.first / v : Vec3(0);
    m.volume.error = half_width([&](std::size_t r) { return parts[r].volume; }) + mean.slack;
    m.area.error = half_width([&](std::size_t r) { return parts[r].area; });
    for (std::size_t i = 0; i < 3; ++i) {
        const int k = static_cast<int>(i);
        const double w = half_width([&](std::size_t r) { return parts[r].first[k] - c[k] * parts[r].volume; });
        m.centroid[i].error = v > 0 ? w / v : std::numeric_limits<double>::infinity();
    }
    // Product of coordinates a and b about the centroid, entry s of `second`.
    const auto central = [&](const ChordSums& p, std::size_t s, int a, int b) {
        return p.second[s] - c[a] * p.first[b] - c[b] * p.first[a] + c[a] * c[b] * p.volume;
    };
    static constexpr std::array<std::array<int, 2>, 6> kPairs{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
    const auto pair = [&](const ChordSums& p, std::size_t s) { return central(p, s, kPairs[s][0], kPairs[s][1]); };
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            m.inertia[3 * row + column].error = half_width([&](std::size_t r) {
                if (row == column) return pair(parts[r], (row + 1) % 3) + pair(parts[r], (row + 2) % 3);
                return pair(parts[r], row + column + 2);
            });
}

}  // namespace

Measured mean_of(const std::array<double, kRandomisations>& values) {
    double mean = 0, squares = 0;
    for (const double v : values) mean += v;
    mean /= kRandomisations;
    for (const double v : values) squares += (v - mean) * (v - mean);
    return {mean, kStudent99 * std::sqrt(squares / (kRandomisations - 1) / kRandomisations), ErrorKind::kConfidence99};
}

Result<Measurement> measure_by_lines(const MeasureJob& job) {
    Measurement m;
    m.method = "lines";
    const double n = lines_of_sheet(job, m.counters);
    std::array<ChordSums, kRandomisations> parts;
    ChordSums mean;
    for (std::size_t r = 0; r < kRandomisations; ++r) {
        const SheetSums one = sum_sheets(job, r, n, m.counters);
        parts[r] = one.sums;
        m.lines += one.lines;
        if (job.cancelled()) return fail(Fault::kInterrupted, "interrupted");
        if (parts[r].unbounded) return fail(Fault::kScene, "the solid is unbounded: it has no volume to measure");
        mean += parts[r];
    }
    mean = mean.scaled(1.0 / kRandomisations);
    set_values(m, mean, job.center());
    set_errors(m, parts, mean);
    m.volume.kind = m.area.kind = ErrorKind::kConfidence99;
    for (Measured& c : m.centroid) c.kind = ErrorKind::kConfidence99;
    for (Measured& i : m.inertia) i.kind = ErrorKind::kConfidence99;
    return m;
}

}  // namespace whittle
