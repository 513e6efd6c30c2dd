// test_files.cpp — what is written reads back: to the bit where the format holds doubles.
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "modeler/mesh/mesh_files.h"
#include "solids.h"

using namespace whittle;
using namespace whittle::test;

namespace {

constexpr MeshFormat kFormats[] = {MeshFormat::kStlBinary, MeshFormat::kStlAscii, MeshFormat::kOff, MeshFormat::kObj, MeshFormat::kPly};
constexpr const char* kNames[] = {"m.stl", "m.stl", "m.off", "m.obj", "m.ply"};

MeshResult part() {
    SolidBuilder b;
    Label red;
    red.material.color = Vec4{1, 0, 0, 1};
    Use body = at(b.shape(shape::Box{Vec3(-10), Vec3(10)}));
    body.label = b.label(red);
    const NodeId cylinder = b.shape(shape::Frustum{-11, 11, 6, 6});
    MeshOptions options;
    options.tolerance_mm = 0.05;
    return meshed(b, b.combine(SetOp::kDifference, {body, at(cylinder, {0.1, 0.2, 0})}), options);
}

struct Scratch {  // a folder that goes away
    std::filesystem::path path = std::filesystem::temp_directory_path() / ("whittle_mesh_test_" + std::to_string(getpid()));
    Scratch() { std::filesystem::create_directories(path); }
    ~Scratch() { std::filesystem::remove_all(path); }
};

}  // namespace

TEST_CASE("OFF, OBJ and PLY give back every bit") {
    const MeshResult made = part();
    for (const int i : {2, 3, 4}) {
        const auto file = write_mesh(made, kFormats[i]);
        REQUIRE(file);
        const auto read = read_mesh(file->bytes, kNames[i]);
        REQUIRE(read);
        CHECK(read->points == made.mesh.points);
        CHECK(read->triangles == made.mesh.triangles);
        CHECK(file->warnings.empty());
    }
}

TEST_CASE("STL gives back the float32 points, closed") {
    const MeshResult made = part();
    for (const int i : {0, 1}) {
        const auto file = write_mesh(made, kFormats[i]);
        REQUIRE(file);
        CHECK(file->report.valid());
        const auto read = read_mesh(file->bytes, kNames[i]);
        REQUIRE(read);
        CHECK(read->triangles.size() == made.mesh.triangles.size());
        CHECK(report_mesh(*read).valid());
        CHECK(mass_properties(*read).volume == Approx(volume(made)).epsilon(1e-6));
    }
}

TEST_CASE("the same mesh gives the same bytes") {
    for (const MeshFormat f : kFormats) CHECK(write_mesh(part(), f)->bytes == write_mesh(part(), f)->bytes);
}

TEST_CASE("a point far finer than float32 is merged in STL and the mesh stays closed") {
    SolidBuilder b;
    const NodeId big = b.shape(shape::Box{Vec3(0), Vec3(1000)}), chip = b.shape(shape::Box{{500, 500, 999}, {500.00001, 500.00001, 1001}});
    const MeshResult r = meshed(b, b.combine(SetOp::kUnion, {at(big), at(chip)}));
    const auto file = write_mesh(r, MeshFormat::kStlBinary);
    REQUIRE(file);
    CHECK(file->report.valid());
    CHECK(file->report.triangles < r.mesh.triangles.size());
}

TEST_CASE("an empty mesh is not written, an unknown suffix is refused") {
    CHECK_FALSE(write_mesh(MeshResult{}, MeshFormat::kOff));
    CHECK(mesh_format("a.STL", false).value() == MeshFormat::kStlBinary);
    CHECK(mesh_format("a.stl", true).value() == MeshFormat::kStlAscii);
    CHECK_FALSE(mesh_format("a.step", false));
}

TEST_CASE("colours are written where the author named some") {
    const auto file = write_mesh(part(), MeshFormat::kOff);
    CHECK(file->bytes.find(" 255 0 0\n") != std::string::npos);
    CHECK(file->bytes.find(" 249 215 44\n") == std::string::npos);  // the cutter names no colour: its faces are the body's
    CHECK(write_mesh(part(), MeshFormat::kPly)->bytes.find("property uchar red") != std::string::npos);
}

TEST_CASE("broken files are refused, whatever is cut off") {
    for (int i = 0; i < 5; ++i) {
        const std::string bytes = write_mesh(part(), kFormats[i])->bytes;
        for (const double share : {0.0, 0.01, 0.3, 0.9}) {
            const auto read = read_mesh(std::string_view(bytes).substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))), kNames[i]);
            if (read) CHECK(read->triangles.size() < part().mesh.triangles.size());
        }
    }
    CHECK_FALSE(read_mesh("OFF\n4000000000 4000000000 0\n", "m.off"));
    CHECK_FALSE(read_mesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n", "m.off"));
    CHECK_FALSE(read_mesh("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", "m.off"));
}

TEST_CASE("OpenMesh reads every format as a closed surface") {
    using Independent = OpenMesh::TriMesh_ArrayKernelT<>;
    const Scratch scratch;
    MeshResult made = part();
    for (MeshLeaf& leaf : made.leaves) leaf.material.color.reset();  // its OFF reader stumbles over colours of faces
    for (int i = 0; i < 5; ++i) {
        const auto path = scratch.path / kNames[i];
        std::ofstream(path, std::ios::binary) << write_mesh(made, kFormats[i])->bytes;
        INFO(kNames[i] << " " << i);
        Independent mesh;
        REQUIRE(OpenMesh::IO::read_mesh(mesh, path.string()));
        CHECK(mesh.n_faces() == made.mesh.triangles.size());
        CHECK(mesh.n_vertices() == made.mesh.points.size());
        for (const auto e : mesh.edges()) CHECK_FALSE(mesh.is_boundary(e));
    }
}

TEST_CASE("admesh finds nothing to repair") {
    if (std::system("command -v admesh > /dev/null 2>&1") != 0) return;
    const Scratch scratch;
    std::ofstream(scratch.path / "m.stl", std::ios::binary) << write_mesh(part(), MeshFormat::kStlBinary)->bytes;
    const std::string command = "admesh " + (scratch.path / "m.stl").string() + " > " + (scratch.path / "report").string() + " 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    std::ifstream report(scratch.path / "report");
    std::string text(std::istreambuf_iterator<char>(report), {});
    const auto number_after = [&](const std::string& label) {
        const auto at_label = text.find(label);
        REQUIRE(at_label != std::string::npos);
        return std::atoi(text.c_str() + text.find(':', at_label) + 1);
    };
    CHECK(number_after("Degenerate facets") == 0);
    CHECK(number_after("Edges fixed") == 0);
    CHECK(number_after("Facets removed") == 0);
    CHECK(number_after("Facets added") == 0);
    CHECK(number_after("Facets reversed") == 0);
    CHECK(number_after("Backwards edges") == 0);
}
