// agreement.cpp — sixteen randomisations of uniformly distributed lines, and the comparison of the volumes.
#include "modeler/check/agreement.h"

#include <algorithm>
#include <cmath>

#include "modeler/check/line_comparison.h"
#include "modeler/check/measure_methods.h"
#include "modeler/check/own_deviation.h"
#include "modeler/check/parallel_lines.h"
#include "modeler/check/sobol.h"

namespace whittle {

namespace {

// Rounding that any mesh may have, as a share of the model's size and its distance from the origin.
constexpr double kMeshRounding = 0x1p-40;
// What the spans' own ends and the distances of leaves may lose, likewise.
constexpr double kOwnRounding = 0x1p-44;
// Grid steps by which a surface may be off: a corner goes to its grid point, at most half a step in each coordinate, and may take the doubles of another
// leaf's corner there, half a step further; twice that where two such surfaces bound a film. 4 > 2 * sqrt(3).
constexpr double kGridSteps = 4;
// Volumes are compared at so many half widths of the 99 % interval: at 15 degrees of freedom a false alarm in three million checks.
constexpr double kVolumeIntervals = 3;
// Lines that measure the exact volume for (iii): its error is then far below what the tessellation takes away.
constexpr std::uint64_t kVolumeLines = 200'000;
// Work of the default number of lines, in units of a primitive's test, and the lines of one randomisation.
constexpr double kWorkBudget = 6e6;
constexpr double kWorkOfALine = 40;
constexpr int kLeastLog2 = 6, kMostLog2 = 12;

struct Sphere {
    Vec3 center{0};
    double radius = 0;
};

Bounds joined(const Bounds& a, const Bounds& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
}

Sphere sphere_around(const Bounds& b) { return {b.lo + (b.hi - b.lo) * 0.5, glm::length(b.hi - b.lo) / 2 * (1 + 0x1p-40)}; }

// Line k of a randomisation: direction uniform on the sphere, place uniform on the disc across it.
Ray uniform_line(const Sphere& sphere, const ScrambledSobol& points, std::uint32_t k) {
    const double z = 1 - 2 * points.at(k, 0), phi = 2 * M_PI * points.at(k, 1), r = std::sqrt(std::max(0.0, 1 - z * z));
    const Vec3 d = glm::normalize(Vec3(r * std::cos(phi), r * std::sin(phi), z));
    const Vec3 a = glm::abs(d);
    const Vec3 least = a.x <= a.y && a.x <= a.z ? Vec3(1, 0, 0) : a.y <= a.z ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Vec3 u = glm::normalize(glm::cross(d, least)), v = glm::cross(d, u);
    const double s = sphere.radius * std::sqrt(points.at(k, 2)), theta = 2 * M_PI * points.at(k, 3);
    Ray ray;
    ray.origin = sphere.center + s * std::cos(theta) * u + s * std::sin(theta) * v - 1.25 * sphere.radius * d;
    ray.direction = d;
    return ray;
}

ComparisonSums compare_lines(const Comparison& comparison, const Sphere& sphere, std::uint64_t seed, std::uint64_t n, const AgreementOptions& options,
                             EngineCounters& counters) {
    const ScrambledSobol points(seed);
    return sum_over_lines<ComparisonSums, ComparisonScratch>(n, options.cancel, counters, [&](std::uint64_t k, ComparisonScratch& scratch, ComparisonSums& sums) {
        compare_on_line(comparison, uniform_line(sphere, points, static_cast<std::uint32_t>(k)), scratch, sums);
    });
}

// Line k of those through facets: through a random point of one, at most 45 degrees or so from its normal.
Ray facet_line(const Mesh& mesh, const Sphere& sphere, const ScrambledSobol& points, std::uint64_t triangle, std::uint32_t k) {
    const Triangle& t = mesh.triangles[triangle];
    const Vec3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]], normal = glm::cross(b - a, c - a);
    const double s = std::sqrt(points.at(k, 0)), u = points.at(k, 1), z = 1 - 2 * points.at(k, 2), phi = 2 * M_PI * points.at(k, 3);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const Vec3 any(r * std::cos(phi), r * std::sin(phi), z);
    const double length = glm::length(normal);
    const Vec3 d = glm::normalize((length > 0 ? normal / length : Vec3(0)) + any * 0.7);
    Ray ray;
    ray.origin = (1 - s) * a + s * (1 - u) * b + s * u * c - 2.25 * sphere.radius * d;
    ray.direction = d;
    return ray;
}

// One line through every facet, or through evenly chosen ones where there are more than `most`.
ComparisonSums compare_facets(const Comparison& comparison, const Sphere& sphere, std::uint64_t most, const AgreementOptions& options, EngineCounters& counters) {
    const ScrambledSobol points(mixed(options.seed, 0x6661636574));
    const std::uint64_t facets = comparison.mesh.triangles.size(), n = std::min(facets, most);
    return sum_over_lines<ComparisonSums, ComparisonScratch>(n, options.cancel, counters, [&](std::uint64_t k, ComparisonScratch& scratch, ComparisonSums& sums) {
        const std::uint64_t triangle = n == facets ? k : (k * facets + mixed(options.seed, k) % facets) / n % facets;
        compare_on_line(comparison, facet_line(comparison.mesh, sphere, points, triangle, static_cast<std::uint32_t>(k)), scratch, sums);
    });
}

std::uint64_t lines_each(const Comparison& comparison, const Sphere& sphere, const AgreementOptions& options, EngineCounters& counters) {
    if (options.lines != 0) return (options.lines + kRandomisations - 1) / kRandomisations;
    EngineCounters pilot;
    compare_lines(comparison, sphere, mixed(options.seed, 0x70696C6F74), kLinesPerBlock, options, pilot);
    counters += pilot;
    const double work = kWorkOfALine + static_cast<double>(pilot.primitive_tests) / kLinesPerBlock;
    return std::uint64_t{1} << std::clamp(static_cast<int>(std::log2(kWorkBudget / (work * kRandomisations))), kLeastLog2, kMostLog2);
}

bool is_usable(const Mesh& mesh) {
    const auto good = [&](std::uint32_t v) { return v < mesh.points.size(); };
    return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) { return std::all_of(t.begin(), t.end(), good); }) &&
           std::all_of(mesh.points.begin(), mesh.points.end(), [](Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
}

void set_mesh_facts(Agreement& a, const Mesh& mesh, double extent) {
    const MassProperties mass = mass_properties(mesh);
    const MeshReport report = report_mesh(mesh);
    const double area_error = 0x1p-46 * mass.area;
    a.volume_mesh = {mass.volume, area_error * extent, ErrorKind::kBound};
    a.area_mesh = {mass.area, area_error, ErrorKind::kBound};
    for (std::size_t i = 0; i < 3; ++i) a.centroid_mesh[i] = {mass.centroid[static_cast<int>(i)], 0x1p-46 * extent, ErrorKind::kBound};
    if (report.open_edges > 0) {
        Disagreement d;
        d.kind = DisagreementKind::kOpen;
        d.distance = static_cast<double>(report.open_edges);
        ++a.disagreements_in_all;
        a.disagreements.push_back(d);
    }
    a.genus = static_cast<int>(report.genus);
    a.components = static_cast<int>(report.components);
}

void set_spans_facts(Agreement& a, const Measurement& m) {
    a.volume_spans = m.volume;
    a.area_spans = m.area;
    a.centroid_spans = m.centroid;
    a.counters += m.counters;
}

// (iii): volumes and the room between them.
void compare_volumes(Agreement& a, double bound) {
    a.difference_bound = bound;
    Disagreement d;
    d.kind = DisagreementKind::kVolume;
    d.distance = std::fabs(a.volume_mesh.value - a.volume_spans.value);
    d.bound = bound + kVolumeIntervals * a.volume_spans.error + a.volume_mesh.error;
    d.in_mesh = a.volume_mesh.value > a.volume_spans.value;
    if (!(d.distance > d.bound)) return;
    ++a.disagreements_in_all;
    a.disagreements.push_back(d);
}

}  // namespace

const char* name_of(DisagreementKind kind) {
    switch (kind) {
        case DisagreementKind::kPiece: return "piece";
        case DisagreementKind::kCrossing: return "crossing";
        case DisagreementKind::kOddLine: return "odd";
        case DisagreementKind::kOpen: return "open";
        case DisagreementKind::kVolume: return "volume";
    }
    return "";
}

double allowed_rounding(double grid_mm, double reach) { return (grid_mm > 0 ? kGridSteps * grid_mm : kMeshRounding * reach) + kOwnRounding * reach; }

Result<Agreement> check_agreement(const Solid& solid, const Program& program, const Mesh& mesh, const AgreementOptions& options) {
    if (!is_usable(mesh)) return fail(Fault::kScene, "the mesh has indices or coordinates that mean nothing");
    Result<LeafDistances> leaves = LeafDistances::of(solid);
    if (!leaves) return tl::unexpected(leaves.error());
    MeasureOptions measure_options;
    measure_options.seed = options.seed;
    measure_options.lines = kVolumeLines;
    measure_options.cancel = options.cancel;
    const Result<Measurement> measured = measure(solid, program, measure_options);
    if (!measured) return tl::unexpected(measured.error());

    Agreement a;
    const Sphere sphere = sphere_around(joined(program_bounds(program), mesh_bounds(mesh)));
    const double reach = 2 * sphere.radius + glm::length(sphere.center);
    a.seed = options.seed;
    a.own_deviation = own_deviation(solid);
    a.tolerance = leaves->any_curved() ? options.tolerance + a.own_deviation : 0;
    a.rounding = allowed_rounding(options.rounding, reach);
    set_spans_facts(a, *measured);
    set_mesh_facts(a, mesh, reach);

    const MeshRays mesh_rays(mesh);
    const Comparison comparison{program, mesh, mesh_rays, *leaves, a.tolerance + a.rounding, a.rounding, options.keep};
    const std::uint64_t n = lines_each(comparison, sphere, options, a.counters);
    const double disc = M_PI * sphere.radius * sphere.radius;
    ComparisonSums all;
    std::array<double, kRandomisations> difference{};
    for (std::size_t r = 0; r < kRandomisations; ++r) {
        const ComparisonSums sums = compare_lines(comparison, sphere, mixed(mixed(options.seed, 0x636865636B), r), n, options, a.counters);
        if (options.cancel && options.cancel->load()) return fail(Fault::kInterrupted, "interrupted");
        if (sums.unbounded) return fail(Fault::kScene, "the solid is unbounded: it cannot be compared with a mesh");
        difference[r] = disc * sums.difference / static_cast<double>(n);
        all += sums;
        if (options.progress) options.progress(static_cast<double>(r + 1) / kRandomisations);
    }
    a.lines = n * kRandomisations;
    a.facet_lines = std::min<std::uint64_t>(mesh.triangles.size(), a.lines);
    ComparisonSums facets = compare_facets(comparison, sphere, a.facet_lines, options, a.counters);
    facets.chord_spans = facets.chord_mesh = facets.difference = 0;
    // These lines seek out slivers, where the place of a crossing is too uncertain to call for a change of membership: only pieces count.
    std::erase_if(facets.disagreements, [](const Disagreement& d) { return d.kind == DisagreementKind::kCrossing; });
    facets.disagreements_in_all = facets.disagreements.size();
    if (facets.worst.kind == DisagreementKind::kCrossing) facets.worst = {};
    all += facets;
    a.difference_volume = mean_of(difference);
    a.worst = all.worst;
    a.disagreements.insert(a.disagreements.end(), all.disagreements.begin(), all.disagreements.end());
    a.disagreements_in_all += all.disagreements_in_all;
    // Films as thin as rounding may have an area where the exact solid has none.
    compare_volumes(a, comparison.curved_bound * (a.area_spans.value + a.area_spans.error) + a.rounding * a.area_mesh.value);
    if (a.disagreements.size() > options.keep) a.disagreements.resize(options.keep);
    a.agree = a.disagreements_in_all == 0;
    return a;
}

}  // namespace whittle
