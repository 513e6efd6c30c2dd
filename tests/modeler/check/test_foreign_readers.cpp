// test_foreign_readers.cpp — meshes of random trees with planted coincidences, before and after they are written: valid by our own counts, by CGAL's,
// OpenMesh's and admesh's.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/mesh_queries.h"
#include "tests/support/random_solid.h"
#include "tests/support/seed.h"

using namespace whittle;

namespace {

class ScratchFile {
public:
    ScratchFile() : path_(std::filesystem::temp_directory_path() / ("whittle_readers_" + std::to_string(getpid()))) {}
    ~ScratchFile() {
        std::error_code ignored;
        std::filesystem::remove(stl(), ignored);
        std::filesystem::remove(report(), ignored);
        std::filesystem::remove(off(), ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    std::string stl() const { return path_.string() + ".stl"; }
    std::string off() const { return path_.string() + ".off"; }
    std::string report() const { return path_.string() + ".txt"; }

private:
    std::filesystem::path path_;
};

// What admesh would have to do to the file: the sum of its repairs. Negative: it did not read it.
long repairs_by_admesh(const std::string& bytes) {
    const ScratchFile scratch;
    std::ofstream(scratch.stl(), std::ios::binary) << bytes;
    if (std::system(("admesh '" + scratch.stl() + "' > '" + scratch.report() + "' 2>&1").c_str()) != 0) return -1;
    std::ifstream in(scratch.report());
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    long sum = 0;
    for (const char* what : {"Degenerate facets", "Edges fixed", "Facets removed", "Facets added", "Facets reversed", "Backwards edges"}) {
        const auto at = text.find(what);
        const auto colon = text.find(':', at);
        if (at == std::string::npos || colon == std::string::npos) return -1;
        sum += std::strtol(text.c_str() + colon + 1, nullptr, 10);
    }
    return sum;
}

// Does OpenMesh take every facet, and find no border? Parts that touch in an edge have points of their own there.
bool whole_to_openmesh(const MeshResult& made) {
    const auto file = write_mesh(made, MeshFormat::kOff);
    REQUIRE(file);
    const ScratchFile scratch;
    std::ofstream(scratch.off(), std::ios::binary) << file->bytes;
    OpenMesh::TriMesh_ArrayKernelT<> mesh;
    if (!OpenMesh::IO::read_mesh(mesh, scratch.off()) || mesh.n_faces() != made.mesh.triangles.size()) return false;
    return std::none_of(mesh.halfedges_begin(), mesh.halfedges_end(), [&](const auto& h) { return mesh.is_boundary(h); });
}

// Counts trees whose mesh is valid, in double by our count and CGAL's, and whose STL admesh loads without a repair. The others are named. Parts that touch in
// an edge are legal, but admesh joins facets by edges and takes them for a fault: those are not given to it.
std::uint64_t well_read(std::uint64_t count, std::uint64_t first = 0) {
    constexpr support::Theme kThemes[] = {support::Theme::kPlanes, support::Theme::kRound, support::Theme::kEverything, support::Theme::kStack};
    const bool has_admesh = std::system("command -v admesh > /dev/null 2>&1") == 0;
    std::uint64_t good = 0;
    for (std::uint64_t i = first; i < first + count; ++i) {
        const support::Theme theme = kThemes[i % std::size(kThemes)];
        const support::RandomSolid tree = support::random_solid(theme, 1 + i / std::size(kThemes));
        INFO(support::name_of(theme) << " " << 1 + i / std::size(kThemes));
        MeshControl control;
        const auto made = mesh_solid(tree.solid, {}, control);
        if (!made) {
            WARN(support::name_of(theme) << " " << 1 + i / std::size(kThemes) << ": " << made.error().message);
            continue;
        }
        if (made->mesh.triangles.empty()) {
            ++good;
            continue;
        }
        const auto crossings = count_self_intersections(made->mesh);
        REQUIRE(crossings);
        const auto file = write_mesh(*made, MeshFormat::kStlBinary);
        REQUIRE(file);
        long repairs = 0;
        if (has_admesh && file->report.shared_edges == 0) repairs = repairs_by_admesh(file->bytes);
        const std::uint64_t single = file->report.self_intersections.value_or(0);
        const bool whole = whole_to_openmesh(*made);
        if (whole && made->report.valid() && made->report.self_intersections == 0U && *crossings == 0 && file->report.valid() && single == 0 && repairs == 0) {
            ++good;
            continue;
        }
        WARN(support::name_of(theme) << " " << 1 + i / std::size(kThemes) << ": crossings " << made->report.self_intersections.value_or(0) << " (CGAL " << *crossings
                                     << "), in float32 " << single << ", repairs by admesh " << repairs << (file->report.valid() ? "" : ", not valid") << (whole ? "" : ", not whole to OpenMesh"));
    }
    return good;
}

}  // namespace

TEST_CASE("meshes of random trees are valid and need no repair") { CHECK(well_read(8) == 8); }

// In tens, so that a run that is stopped has said how far it came; WHITTLE_FROM is the first tree.
TEST_CASE("meshes of 200 random trees are valid and need no repair", "[.][soak]") {
    for (std::uint64_t first = support::first_of_run(); first < 200; first += 10) {
        CHECK(well_read(10, first) == 10);
        WARN("asked up to " << first + 10);
    }
}
