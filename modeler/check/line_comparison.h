// line_comparison.h — one line through the exact solid and through the mesh: what they do not share, judged by bounds given beforehand.
#pragma once

#include <vector>

#include "modeler/check/agreement.h"
#include "modeler/check/leaf_distance.h"
#include "modeler/mesh/mesh_queries.h"

namespace whittle {

// What the comparison of a line needs; shared by all threads.
struct Comparison {
    const Program& program;
    const Mesh& mesh;
    const MeshRays& mesh_rays;
    const LeafDistances& leaves;
    double curved_bound = 0;  // from a curved face: tolerance and rounding
    double flat_bound = 0;    // from a flat face: rounding
    std::size_t keep = 20;
};

// Per thread.
struct ComparisonScratch {
    Scratch engine;
    Spans spans, probe;
    std::vector<MeshCrossing> crossings;
};

// Sums over lines; disagreements are kept worst first, of equal ones the earlier.
struct ComparisonSums {
    double chord_spans = 0, chord_mesh = 0, difference = 0;
    bool unbounded = false;
    std::uint64_t disagreements_in_all = 0;
    std::vector<Disagreement> disagreements;
    Disagreement worst;

    ComparisonSums& operator+=(const ComparisonSums& o);
};

// Adds one line. `ray` starts outside both and has a direction of unit length up to rounding.
void compare_on_line(const Comparison& comparison, const Ray& ray, ComparisonScratch& scratch, ComparisonSums& sums);

}  // namespace whittle
