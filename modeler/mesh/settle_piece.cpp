#include "modeler/mesh/settle_piece.h"

#include <cmath>
#include <limits>

#include "modeler/arrange/arrange.h"
#include "modeler/arrange/crossings.h"
#include "modeler/mesh/weld.h"

namespace whittle {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// All triangles with a corner of a chosen one.
void grow(const Mesh& mesh, std::vector<bool>& chosen) {
    std::vector<bool> near(mesh.points.size(), false);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i])
            for (const std::uint32_t v : mesh.triangles[i]) near[v] = true;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        if (near[t[0]] || near[t[1]] || near[t[2]]) chosen[i] = true;
    }
}

DoubleBox box_of(const Mesh& mesh, const Triangle& t) {
    const auto at = [&](std::size_t k) { return std::array<double, 3>{mesh.points[t[k]].x, mesh.points[t[k]].y, mesh.points[t[k]].z}; };
    DoubleBox box = DoubleBox::at(at(0));
    box.include(at(1)), box.include(at(2));
    return box;
}

// The chosen triangles on a grid of 2^exponent, each with a tag of its own; `numbers` are those they have in the mesh.
GridMesh piece_of(const Mesh& mesh, const std::vector<bool>& chosen, int exponent, std::vector<std::uint32_t>& numbers) {
    GridMesh piece;
    std::vector<std::uint32_t> renamed(mesh.points.size(), kNone);
    for (std::uint32_t i = 0; i < chosen.size(); ++i) {
        if (!chosen[i]) continue;
        Triangle t = mesh.triangles[i];
        for (std::uint32_t& v : t) {
            if (renamed[v] == kNone) {
                renamed[v] = static_cast<std::uint32_t>(piece.points.size());
                const auto whole = [&](int k) { return std::llround(std::ldexp(mesh.points[v][k], -exponent)); };
                piece.points.push_back({whole(0), whole(1), whole(2)});
            }
            v = renamed[v];
        }
        piece.triangles.push_back(t);
        piece.tags.push_back(static_cast<FacetTag>(numbers.size()));
        numbers.push_back(i);
    }
    return piece;
}

// The triangles that are left, and the new ones behind them.
Mesh replaced(const Mesh& mesh, const std::vector<bool>& chosen, const ArrangedMesh& made, const std::vector<std::uint32_t>& numbers, int exponent) {
    Mesh out;
    out.points = mesh.points;
    const auto first = static_cast<std::uint32_t>(out.points.size());
    const auto rounded = [&](double x) { return std::ldexp(std::nearbyint(x), exponent); };
    for (const Vec3& p : made.points) out.points.emplace_back(rounded(p.x), rounded(p.y), rounded(p.z));
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (chosen[i]) continue;
        out.triangles.push_back(mesh.triangles[i]);
        if (!mesh.leaf.empty()) out.leaf.push_back(mesh.leaf[i]);
    }
    for (std::size_t i = 0; i < made.triangles.size(); ++i) {
        const Triangle& t = made.triangles[i];
        out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        if (!mesh.leaf.empty()) out.leaf.push_back(mesh.leaf[numbers[made.tags[i]]]);
    }
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

// Around the chosen triangles, a little wider than rounding can carry a point.
BoxTree boxes_around(const Mesh& mesh, const std::vector<bool>& chosen, int exponent) {
    const double margin = std::ldexp(2.0, exponent);
    std::vector<DoubleBox> boxes;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        if (!chosen[i]) continue;
        boxes.push_back(box_of(mesh, mesh.triangles[i]));
        for (std::size_t k = 0; k < 3; ++k) boxes.back().lo[k] -= margin, boxes.back().hi[k] += margin;
    }
    std::vector<std::uint32_t> owner(boxes.size(), BoxTree::kMixed);
    return BoxTree(std::move(boxes), std::move(owner));
}

}  // namespace

std::optional<CrossingPairs> settle_piece(Mesh& mesh, const CrossingPairs& pairs, int exponent, std::size_t most, MeshControl& control) {
    std::vector<bool> chosen(mesh.triangles.size(), false);
    for (const auto& [i, j] : pairs) chosen[i] = chosen[j] = true;
    const std::vector<bool> crossing = chosen;
    constexpr int kRings = 2;  // one would be enough; a flat triangle that arises at the crossings then still has its neighbours
    for (int ring = 0; ring < kRings; ++ring) grow(mesh, chosen);
    std::vector<std::uint32_t> numbers;
    const GridMesh piece = piece_of(mesh, chosen, exponent, numbers);
    std::vector<bool> sound;
    for (const std::uint32_t i : numbers) sound.push_back(!crossing[i]);
    const auto made = arrange_piece(piece, sound, [&] { return control.cancelled(); });
    if (!made) return std::nullopt;
    const BoxTree places = boxes_around(mesh, chosen, exponent);
    mesh = replaced(mesh, chosen, *made, numbers, exponent);
    weld(mesh);
    remove_flat_triangles(mesh);
    return pairs_near(mesh, places, most);
}

}  // namespace whittle
