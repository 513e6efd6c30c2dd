// Meshes that cross themselves where they were rounded: mended there and nowhere else.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeler/arrange/crossings.h"
#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/mesh_queries.h"
#include "modeler/mesh/settle.h"
#include "modeler/mesh/settle_piece.h"
#include "modeler/mesh/weld.h"

using namespace whittle;
using Catch::Matchers::WithinRel;

namespace {

// A cube of n x n squares a side, as one closed shell behind what the mesh has.
void add_cube(Mesh& mesh, const Vec3& lo, double side, int n) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    std::array<std::uint32_t, 4> v{};
                    for (std::size_t c = 0; c < 4; ++c) {
                        Vec3 p = lo;
                        p[axis] += far ? side : 0;
                        p[(axis + 1) % 3] += side * (i + (c == 1 || c == 2 ? 1 : 0)) / n;
                        p[(axis + 2) % 3] += side * (j + (c >= 2 ? 1 : 0)) / n;
                        v[c] = static_cast<std::uint32_t>(mesh.points.size());
                        mesh.points.push_back(p);
                    }
                    if (!far) std::swap(v[1], v[3]);
                    mesh.triangles.push_back({v[0], v[1], v[2]});
                    mesh.triangles.push_back({v[0], v[2], v[3]});
                }
}

Mesh cubes(std::initializer_list<Vec3> places) {
    Mesh mesh;
    for (const Vec3& lo : places) add_cube(mesh, lo, 8, 8);
    weld(mesh);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) mesh.leaf.push_back(i);
    return mesh;
}

}  // namespace

TEST_CASE("where shells of a mesh cross they are united, and the rest stays as it was") {
    Mesh mesh = cubes({Vec3(0), {6.5, 6.25, 6.75}, {30, 0, 0}});
    const Mesh before = mesh;
    const CrossingPairs pairs = crossing_pairs(mesh.points, mesh.triangles, 100000);
    REQUIRE(pairs.size() == count_crossings(mesh.points, mesh.triangles));
    REQUIRE_FALSE(pairs.empty());
    MeshControl control;
    constexpr int kExponent = -20;
    const auto left = settle_piece(mesh, pairs, kExponent, 0, 100000, control);
    REQUIRE(left);
    CHECK(left->empty());
    CHECK(count_crossings(mesh.points, mesh.triangles) == 0);
    CHECK(count_open_edges(mesh.triangles) == 0);
    CHECK_THAT(mass_properties(mesh).volume, WithinRel(3 * 512 - 1.5 * 1.75 * 1.25, 1e-5));
    // The facets of the third, and those of the others that are far from the place, are what they were.
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle &now = mesh.triangles[i], &was = before.triangles[mesh.leaf[i]];
        bool same = true;
        for (std::size_t k = 0; k < 3; ++k) same = same && mesh.points[now[k]] == before.points[was[k]];
        kept += same ? 1 : 0;
    }
    CHECK(kept > before.triangles.size() * 3 / 4);
}

TEST_CASE("settling that is cancelled leaves the mesh") {
    struct Stopped : MeshControl {
        bool cancelled() const override { return true; }
    } stopped;
    Mesh mesh = cubes({Vec3(0), {6.5, 6.25, 6.75}});
    const Mesh before = mesh;
    CHECK_FALSE(settle_piece(mesh, crossing_pairs(mesh.points, mesh.triangles, 1000), -20, 0, 1000, stopped));
    CHECK(mesh == before);
}

TEST_CASE("a mesh crosses no more in float32 than it may, wherever it stands") {
    // Far from the origin floats are coarse: shells that are 1e-6 apart are pressed together or into each other.
    const Mesh mesh = cubes({{1000, 1000, 1000}, {1008 - 1e-6, 1000.3, 1000.2}, {992 + 1e-6, 1000.1, 999.9}});
    MeshControl control;
    const Settled settled = settled_in_single(mesh, control);
    CHECK(settled.crossings == 0);
    CHECK(count_crossings(settled.mesh.points, settled.mesh.triangles) == 0);
    CHECK(count_open_edges(settled.mesh.triangles) == 0);
    CHECK_THAT(mass_properties(settled.mesh).volume, WithinRel(3 * 512.0, 1e-5));
    for (const Vec3& p : settled.mesh.points) CHECK(p == Vec3(glm::vec3(p)));
}

TEST_CASE("what rounding leaves crossing round after round settles on a grid that is coarser there alone") {
    // Where three balls of two thousand meet, as it was after four rounds; whole numbers.
    std::ifstream file(std::filesystem::path(WHITTLE_SOURCE_DIR) / "tests" / "modeler" / "mesh" / "unsettled.off");
    std::stringstream text;
    text << file.rdbuf();
    const auto read = read_mesh(text.str(), "unsettled.off");
    REQUIRE(read);
    const std::uint64_t open = count_open_edges(read->triangles);
    REQUIRE(open > 0);  // it is a part
    for (const bool coarse : {false, true}) {
        Mesh mesh = *read;
        CrossingPairs pairs = crossing_pairs(mesh.points, mesh.triangles, 1000);
        REQUIRE_FALSE(pairs.empty());
        MeshControl control;
        int rounds = 0;
        for (; rounds < 8 && !pairs.empty(); ++rounds) {
            auto left = settle_piece(mesh, pairs, 0, coarse ? 1 + rounds % 4 : 0, 1000, control);
            REQUIRE(left);
            pairs = std::move(*left);
        }
        CHECK(pairs.empty() == coarse);
        CHECK(pairs.size() == count_crossings(mesh.points, mesh.triangles));
        CHECK(count_open_edges(mesh.triangles) == open);
    }
}
