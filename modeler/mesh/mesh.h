// mesh.h — a solid as triangles: the mesh, how it is asked for, what was found about it.
//
// A mesh is made for export and for the check, never to be seen. Leaves are tessellated within a tolerance and put on a decimal grid that is fine
// against the model (about 1e-12 of its size), so that what the author wrote as touching touches; booleans on them are exact
// (modeler/arrange); only the finished mesh is rounded to double.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "csg/base/result.h"
#include "csg/base/vec.h"
#include "csg/solid/solid.h"

namespace whittle {

using Triangle = std::array<std::uint32_t, 3>;

// Closed and oriented: triangles counter-clockwise seen from outside. `leaf[i]` says which leaf use made triangle i (index into
// MeshResult::leaves); empty where nobody knows (a file that was read).
struct Mesh {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> leaf;
    bool operator==(const Mesh&) const = default;
};

Bounds mesh_bounds(const Mesh& mesh);

struct MeshOptions {
    std::optional<double> tolerance_mm;  // chord error; unset: min(1e-3 of the curve's radius, 1e-3 of the model's diagonal)
    std::optional<double> angle_deg;     // also: no segment of a curve turns by more than this
    int threads = 0;                     // 0: all cores. The bytes do not depend on it
    bool decimate = true;                // join exactly coplanar triangles of one facet after each boolean
};

// How a caller watches and stops the work. Both functions may be called from several threads.
class MeshControl {
public:
    virtual ~MeshControl() = default;
    virtual bool cancelled() const { return false; }
    virtual void progress(double /*share_done*/) {}
};

// One use of a shape, in author's order. `material` is the whole path's, outermost winning.
struct MeshLeaf {
    Material material;
    SourcePlace place;
    std::string part;  // name of the outermost part() around it; empty: none
    std::uint32_t subtractions = 0;  // differences as whose cutter it stands, or within
    std::int64_t cut_order = 0;      // of two cutters the one whose colour comes first: at each difference what it subtracts comes before what it is subtracted from
    std::optional<Material> filled;  // of a cutter that names no surface, for the triangles where it is known: the matter that remains there

    bool subtracts() const { return subtractions > 0; }
    // What its triangles show.
    const Material& shown() const { return filled ? *filled : material; }
};

// Counts of work done, names as in --stats.
struct MeshStats {
    std::uint64_t leaves = 0;            // tessellated uses
    std::uint64_t booleans = 0;          // mesh.booleans: exact operations on two meshes
    std::uint64_t fallbacks = 0;         // mesh.fallback: of these, done by Nef polyhedra
    std::uint64_t reused = 0;            // skip.mesh_equal: results taken from an equal part, also modulo translation
    std::uint64_t skipped_boxes = 0;     // skip.mesh_boxes: operations decided by boxes alone
    std::uint64_t decimated = 0;         // vertices removed
    bool loaded_cgal = false;            // loaded.cgal
    double seconds_tessellate = 0, seconds_boolean = 0, seconds_decimate = 0, seconds_round = 0;
};

// What validation found. A mesh is fit for export when valid(): closed, oriented, no degenerate and no duplicate facet.
struct MeshReport {
    std::uint64_t triangles = 0, vertices = 0;
    std::uint64_t components = 0;          // shells: triangles connected through edges of two
    std::int64_t genus = 0;                // summed over the shells
    std::uint64_t open_edges = 0;          // edges whose two directions are used unequally often
    std::uint64_t shared_edges = 0;        // edges of 2k > 2 triangles, paired: legal, solids touch there
    std::uint64_t degenerate = 0;          // triangles of no area in the precision asked
    std::uint64_t duplicate = 0;           // triangles on the same three points
    std::optional<std::uint64_t> self_intersections;  // pairs of triangles that cross; only where asked
    bool valid() const { return open_edges == 0 && degenerate == 0 && duplicate == 0; }
};

struct MeshResult {
    Mesh mesh;
    std::vector<MeshLeaf> leaves;
    MeshReport report;                  // of `mesh`, in double
    MeshStats stats;
    double tolerance_mm = 0;            // no point of a true curved face is farther from its tessellation
    double grid_mm = 0;                 // leaf vertices were moved by at most half of this in each coordinate; 0: not at all
    std::vector<std::string> warnings;  // EXPORT-WARNING texts
};

// The solid at time 0 as one mesh. An empty solid gives an empty mesh.
// Errors: kScene for an unbounded or 2D root, an open or self-crossing polyhedron; kInterrupted when cancelled.
Result<MeshResult> mesh_solid(const Solid& solid, const MeshOptions& options, MeshControl& control);

// The same for one use of a node, in the frame the use stands in; the solid need not have a root.
Result<MeshResult> mesh_use(const Solid& solid, const Use& use, const MeshOptions& options, MeshControl& control);

// Facts of a mesh as it stands. Points that are equal count as one vertex.
MeshReport report_mesh(const Mesh& mesh);

// The tolerance that options mean for a solid whose longest curve radius is `radius` and whose diagonal is `diagonal`.
double chord_tolerance(const MeshOptions& options, double radius, double diagonal);

}  // namespace whittle
