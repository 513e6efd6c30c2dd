#include "modeler/mesh/settle_piece.h"

#include <array>
#include <cmath>
#include <set>

#include "modeler/arrange/arrange.h"
#include "modeler/arrange/crossings.h"
#include "modeler/mesh/mesh_part.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

DoubleBox box_of(const Mesh& mesh, const Triangle& t) {
    const auto at = [&](std::size_t k) { return std::array<double, 3>{mesh.points[t[k]].x, mesh.points[t[k]].y, mesh.points[t[k]].z}; };
    DoubleBox box = DoubleBox::at(at(0));
    box.include(at(1)), box.include(at(2));
    return box;
}

// On a grid of 2^exponent, each triangle with a tag of its own.
GridMesh on_grid(const Mesh& part, int exponent) {
    GridMesh grid;
    const auto whole = [&](double x) { return std::llround(std::ldexp(x, -exponent)); };
    for (const Vec3& p : part.points) grid.points.push_back({whole(p.x), whole(p.y), whole(p.z)});
    grid.triangles = part.triangles;
    for (FacetTag i = 0; i < part.triangles.size(); ++i) grid.tags.push_back(i);
    return grid;
}

using Points = std::set<std::array<double, 3>>;

// Those that chosen triangles have in common with others.
Points rim_of(const Mesh& mesh, const std::vector<bool>& chosen) {
    std::vector<bool> outside(mesh.points.size(), false);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (!chosen[i])
            for (const std::uint32_t v : mesh.triangles[i]) outside[v] = true;
    Points rim;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i])
            for (const std::uint32_t v : mesh.triangles[i])
                if (outside[v]) rim.insert({mesh.points[v].x, mesh.points[v].y, mesh.points[v].z});
    return rim;
}

// Rounded to the grid, or to one coarser by so many bits but on the rim; `was` is what was arranged.
Mesh off_grid(const ArrangedMesh& made, const Mesh& was, int exponent, int coarser, const Points& rim) {
    Mesh out;
    const auto rounded = [&](double x, int bits) { return std::ldexp(std::nearbyint(std::ldexp(x, -bits)), exponent + bits); };
    for (const Vec3& p : made.points) {
        const std::array<double, 3> fine{rounded(p.x, 0), rounded(p.y, 0), rounded(p.z, 0)};
        const int bits = coarser == 0 || rim.count(fine) != 0 ? 0 : coarser;
        out.points.emplace_back(rounded(p.x, bits), rounded(p.y, bits), rounded(p.z, bits));
    }
    out.triangles = made.triangles;
    if (!was.leaf.empty())
        for (const FacetTag tag : made.tags) out.leaf.push_back(was.leaf[tag]);
    return out;
}

// Of the triangles that touch a box of the tree.
CrossingPairs pairs_near(const Mesh& mesh, const BoxTree& places, std::size_t most) {
    std::vector<std::uint32_t> numbers;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        bool near = false;
        places.touching(box_of(mesh, mesh.triangles[i]), [&](std::uint32_t) { near = true; });
        if (near) numbers.push_back(i), triangles.push_back(mesh.triangles[i]);
    }
    CrossingPairs out = crossing_pairs(mesh.points, triangles, most);
    for (auto& [i, j] : out) i = numbers[i], j = numbers[j];
    return out;
}

// Around the triangles, a little wider than rounding can carry a point.
BoxTree boxes_around(const Mesh& part, int exponent) {
    const double margin = std::ldexp(2.0, exponent);
    std::vector<DoubleBox> boxes;
    for (const Triangle& t : part.triangles) {
        boxes.push_back(box_of(part, t));
        for (std::size_t k = 0; k < 3; ++k) boxes.back().lo[k] -= margin, boxes.back().hi[k] += margin;
    }
    std::vector<std::uint32_t> owner(boxes.size(), BoxTree::kMixed);
    return BoxTree(std::move(boxes), std::move(owner));
}

}  // namespace

Mesh taken_out(Mesh& mesh, CrossingPairs& pairs, int exponent) {
    std::vector<bool> chosen(mesh.triangles.size(), false);
    for (const auto& [i, j] : pairs) chosen[i] = chosen[j] = true;
    constexpr int kInnerRings = 3, kOuterRings = 5;  // what is arranged, a ring or two wider from round to round; and what it must not cross
    for (int ring = 0; ring < kInnerRings; ++ring) grow_by_ring(mesh, chosen);
    const BoxTree places = boxes_around(part_of(mesh, chosen), exponent);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (!chosen[i]) places.touching(box_of(mesh, mesh.triangles[i]), [&](std::uint32_t) { chosen[i] = true; });
    for (int ring = 0; ring < kOuterRings; ++ring) grow_by_ring(mesh, chosen);
    std::vector<std::uint32_t> number(chosen.size(), 0);
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) number[i] = count++;
    for (auto& [i, j] : pairs) i = number[i], j = number[j];
    Mesh part = part_of(mesh, chosen);
    remove_part(mesh, chosen);
    return part;
}

std::optional<CrossingPairs> settle_piece(Mesh& mesh, const CrossingPairs& pairs, int exponent, int coarser, std::size_t most, MeshControl& control) {
    std::vector<bool> chosen(mesh.triangles.size(), false);
    for (const auto& [i, j] : pairs) chosen[i] = chosen[j] = true;
    const std::vector<bool> crossing = chosen;
    constexpr int kRings = 2;  // one would be enough; a flat triangle that arises at the crossings then still has its neighbours
    for (int ring = 0; ring < kRings; ++ring) grow_by_ring(mesh, chosen);
    std::vector<bool> sound;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) sound.push_back(!crossing[i]);
    const Mesh part = part_of(mesh, chosen);
    const auto made = arrange_piece(on_grid(part, exponent), sound, [&] { return control.cancelled(); });
    if (!made) return std::nullopt;
    const BoxTree places = boxes_around(part, exponent + coarser);
    const Points rim = coarser == 0 ? Points() : rim_of(mesh, chosen);
    remove_part(mesh, chosen);
    append(mesh, off_grid(*made, part, exponent, coarser, rim));
    weld(mesh);
    remove_flat_triangles(mesh);
    return pairs_near(mesh, places, most);
}

}  // namespace whittle
