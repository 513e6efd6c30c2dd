// agreement.h — are the exact solid and its mesh one thing? Lines through both, judged by a bound that is fixed before any line is shot.
//
// Lines are distributed uniformly over the bounding sphere (four coordinates, Owen-scrambled Sobol); as many again, at most, go through the facets of the
// mesh, one each, so that what is small is looked at too. On each, the spans of the exact solid and those of the mesh are compared. What may differ is decided by the tolerance of the tessellation and by rounding, never by what is found:
//  (i)   every piece of the symmetric difference lies within `tolerance` of the boundary of some leaf of the solid;
//  (ii)  every crossing of the mesh, zero-length spans included, lies within `tolerance` of a leaf's boundary and of a change of exact membership,
//        unless it ends a piece that (i) explains;
//  (iii) the volumes agree within tolerance times the area that is curved, plus the error of the sampled volume.
// Where rays themselves meet chords of a curve, how far these may be off adds to the tolerance (own_deviation.h).
// With tolerance 0 (faceted mode) rounding alone is allowed.
//
// Source: Crofton's formula: Santalo, Integral Geometry and Geometric Probability (1976).
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/solid/solid.h"
#include "modeler/check/measure.h"
#include "modeler/mesh/mesh.h"
#include "tracer/engine/engine.h"

namespace whittle {

struct AgreementOptions {
    double tolerance = 0;     // largest distance between a leaf's surface and its tessellation, as the mesh was made with; 0: facets only
    double rounding = 0;      // step of the grid that leaf corners were put on; 0: 2^-40 of the model's extent is allowed
    std::uint64_t lines = 0;  // 0: by a count of work, about a second
    std::uint64_t seed = 0;
    std::size_t keep = 20;    // disagreements that are listed
    const std::atomic<bool>* cancel = nullptr;
    std::function<void(double)> progress;  // share done, 0..1; called from one thread at a time
};

enum class DisagreementKind {
    kPiece,     // (i): in one and not the other, too far from every leaf's boundary
    kCrossing,  // (ii): the mesh has a facet where the exact membership does not change
    kOddLine,   // the line crosses the mesh an odd number of times: the mesh is open
    kOpen,      // edges whose two directions are used unequally often
    kVolume     // (iii)
};
const char* name_of(DisagreementKind kind);

struct Disagreement {
    DisagreementKind kind = DisagreementKind::kPiece;
    Ray ray;                    // the line, as `whittle spans --ray` reads it
    double t0 = 0, t1 = 0;      // the piece; equal for a crossing
    bool in_mesh = false;       // the piece is in the mesh and not in the exact solid
    double distance = 0;        // from the nearest leaf's boundary, mm (kOddLine: t1; kOpen: the edges; kVolume: the difference, mm^3)
    double bound = 0;           // what was allowed
    SourcePlace place;          // of the nearest leaf
};

struct Agreement {
    bool agree = true;
    std::uint64_t lines = 0, seed = 0;          // uniform lines
    std::uint64_t facet_lines = 0;              // lines through facets
    double tolerance = 0, rounding = 0;         // `tolerance` includes own_deviation
    double own_deviation = 0;                   // of what rays meet from the solid (own_deviation.h)
    Measured volume_spans, volume_mesh, area_spans, area_mesh;  // the mesh's own are exact up to rounding
    std::array<Measured, 3> centroid_spans, centroid_mesh;
    int genus = 0, components = 0;              // of the mesh's surface
    Measured difference_volume;                 // of the symmetric difference
    double difference_bound = 0;                // tolerance times the area of the leaves that are curved, and rounding times all
    Disagreement worst;                         // the largest distance/bound seen, whether allowed or not
    std::vector<Disagreement> disagreements;    // the worst `keep`, worst first
    std::uint64_t disagreements_in_all = 0;
    EngineCounters counters;
};

// How far a surface may be off by rounding alone: `grid_mm` is the step of the grid that corners were put on (0: unknown), `reach` how far from the origin
// the model extends.
double allowed_rounding(double grid_mm, double reach);

// `mesh` is closed and oriented, in the root frame. `tolerance` and `rounding` are those of its MeshResult. Same bytes at any thread count.
// Fails with kScene where the solid is unbounded or the mesh is not usable (indices out of range), with kInterrupted where `cancel` became true.
Result<Agreement> check_agreement(const Solid& solid, const Program& program, const Mesh& mesh, const AgreementOptions& options);

}  // namespace whittle
