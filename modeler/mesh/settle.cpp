#include "modeler/mesh/settle.h"

#include <algorithm>
#include <cmath>

#include "modeler/arrange/arrange.h"
#include "modeler/arrange/crossings.h"
#include "modeler/mesh/mesh_part.h"
#include "modeler/mesh/settle_piece.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

// Rounds on one grid: what has not settled by then mostly goes round in circles, of points that shapes of no more than a few steps leave no room for. Then, round
// by round, these places alone are put on grids coarser by 1 to 4 bits; and at last the mesh on one twice as coarse, three times at most.
constexpr int kRounds = 4, kCoarserRounds = 8, kMostCoarser = 4, kGrids = 4;
// With more pairs than this the model is too fine for the precision: arranging what crosses would take minutes and help little. They are told instead.
constexpr std::uint64_t kMostCrossings = 20000;
// A mesh of no more triangles is arranged as a whole where its pieces cannot be, and of no more crossings.
constexpr std::size_t kFewTriangles = 200000, kFewCrossings = 2000;

Settled looked_at(Mesh mesh) {
    weld(mesh);
    remove_flat_triangles(mesh);
    Settled out{std::move(mesh), 0, false};
    out.crossings = count_crossings(out.mesh.points, out.mesh.triangles);
    return out;
}

double largest_coordinate(const Mesh& mesh) {
    double most = 0;
    for (const Vec3& p : mesh.points) most = std::max({most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    return most;
}

// The mesh with all points at multiples of 2^exponent, what crosses arranged. Nothing where it cannot be.
std::optional<Mesh> rearranged(const Mesh& mesh, int exponent, MeshControl& control) {
    GridMesh grid;
    for (const Vec3& p : mesh.points) {
        const auto whole = [&](double x) { return std::llround(std::ldexp(x, -exponent)); };
        grid.points.push_back({whole(p.x), whole(p.y), whole(p.z)});
    }
    grid.triangles = mesh.triangles;
    for (FacetTag i = 0; i < mesh.triangles.size(); ++i) grid.tags.push_back(i);
    Expression alone;
    alone.finish(alone.operand());
    const Operand operand{&grid, {}, 0, 0, true};
    ArrangeStats stats;
    auto made = arrange({&operand, 1}, alone, {true, [&] { return control.cancelled(); }}, stats);
    if (!made) return std::nullopt;
    Mesh out;
    for (const Vec3& p : made->points) out.points.push_back({std::ldexp(std::nearbyint(p.x), exponent), std::ldexp(std::nearbyint(p.y), exponent), std::ldexp(std::nearbyint(p.z), exponent)});
    out.triangles = std::move(made->triangles);
    if (!mesh.leaf.empty())
        for (const FacetTag tag : made->tags) out.leaf.push_back(mesh.leaf[tag]);
    return out;
}

Mesh on_grid(const Mesh& mesh, int exponent) {
    Mesh out = mesh;
    for (Vec3& p : out.points)
        for (int k = 0; k < 3; ++k) p[k] = std::ldexp(std::nearbyint(std::ldexp(p[k], -exponent)), exponent);
    return out;
}

// Piece by piece, the mesh on one grid.
Settled settled_by_pieces(Mesh mesh, int exponent, MeshControl& control) {
    weld(mesh);
    remove_flat_triangles(mesh);
    CrossingPairs pairs = crossing_pairs(mesh.points, mesh.triangles, kMostCrossings + 1);
    if (pairs.empty() || pairs.size() > kMostCrossings) return {std::move(mesh), pairs.size(), true};
    Mesh part = taken_out(mesh, pairs, exponent);
    for (int round = 0; round < kRounds + kCoarserRounds && !pairs.empty() && pairs.size() <= kMostCrossings && !control.cancelled(); ++round) {
        const int coarser = round < kRounds ? 0 : 1 + (round - kRounds) % kMostCoarser;
        auto left = settle_piece(part, pairs, exponent, coarser, kMostCrossings + 1, control);
        if (!left) break;
        pairs = std::move(*left);
    }
    append(mesh, part);
    weld(mesh);
    return {std::move(mesh), pairs.size(), true};
}

// As a whole.
void settle_whole(Settled& best, const Mesh& mesh, int exponent, MeshControl& control) {
    Mesh now = mesh;
    std::uint64_t left = best.crossings;
    for (int round = 0; round < kRounds && left > 0 && left <= kFewCrossings && !control.cancelled(); ++round) {
        auto next = rearranged(now, exponent, control);
        if (!next) break;
        now = std::move(*next);
        Settled seen = looked_at(now);
        left = seen.crossings;
        seen.rearranged = true;
        if (left < best.crossings) best = std::move(seen);
    }
}

// On the finest grid whose points have so many bits, else on coarser ones.
Settled settled_on_grid(Settled first, const Mesh& mesh, int bits, MeshControl& control) {
    int exponent = 0;
    std::frexp(largest_coordinate(mesh), &exponent);
    exponent -= bits;
    Settled best = std::move(first);
    for (int coarser = 0; coarser < kGrids && best.crossings > 0 && best.crossings <= kMostCrossings && !control.cancelled(); ++coarser) {
        Settled seen = settled_by_pieces(on_grid(mesh, exponent + coarser), exponent + coarser, control);
        if (seen.crossings < best.crossings) best = std::move(seen);
        if (best.crossings > 0 && mesh.triangles.size() <= kFewTriangles) settle_whole(best, mesh, exponent + coarser, control);
    }
    return best;
}

}  // namespace

Settled settled_in_double(const Mesh& mesh, MeshControl& control) {
    Settled first = looked_at(mesh);
    if (first.crossings == 0) return first;
    constexpr int kBits = 49;  // of kLargestPlacedCoordinate's 50
    return settled_on_grid(std::move(first), mesh, kBits, control);
}

Settled settled_in_single(const Mesh& mesh, MeshControl& control) {
    Mesh rounded = mesh;
    for (Vec3& p : rounded.points) p = Vec3(glm::vec3(p));
    Settled first = looked_at(std::move(rounded));
    if (first.crossings == 0) return first;
    constexpr int kBits = 24;  // of a float's mantissa
    return settled_on_grid(std::move(first), mesh, kBits, control);
}

}  // namespace whittle
