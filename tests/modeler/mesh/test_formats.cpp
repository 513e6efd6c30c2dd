// test_formats.cpp — 3MF, AMF, glTF, OpenMesh and materials: whole, with their parts and colours, and readable by others.
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <unistd.h>
#ifdef WHITTLE_LIB3MF
#include <Model/COM/NMR_DLLInterfaces.h>
#endif

#include "csg/solid/part_solids.h"
#include "modeler/mesh/file_text.h"
#include "modeler/mesh/package_reader.h"
#include "modeler/mesh/weld.h"
#include "modeler/mesh/zip.h"
#include "solids.h"

using namespace whittle;
using namespace whittle::test;

namespace {

Use labelled_use(SolidBuilder& b, NodeId node, Vec3 by, const char* part, std::optional<Vec4> color) {
    Label label;
    label.part = part;
    label.material.color = color;
    Use use = at(node, by);
    use.label = b.label(label);
    return use;
}

// A red body and a blue pin, drilled together.
Solid two_parts() {
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{Vec3(0), Vec3(10)}), pin = b.shape(shape::Box{Vec3(0), Vec3(2, 2, 1.0 / 3)}), drill = b.shape(shape::Box{Vec3(4, 4, -1), Vec3(6, 6, 99)});
    Use both;
    both.node = b.combine(SetOp::kUnion, {labelled_use(b, box, Vec3(0), "bo<dy", Vec4(1, 0, 0, 1)), labelled_use(b, pin, {5, 5, 10}, "pin", Vec4(0, 0, 1, 0.5))});
    Use root;
    root.node = b.combine(SetOp::kDifference, {both, at(drill)});
    return b.finish(root);
}

MeshResult mesh_of(const Solid& solid) {
    MeshControl control;
    auto result = mesh_solid(solid, {}, control);
    if (!result) FAIL(result.error().message);
    return std::move(*result);
}

struct Parts {
    std::vector<NamedSolid> solids = divided_by_part(two_parts());
    std::vector<MeshResult> meshes;
    std::vector<MeshPart> parts;
    Parts() {
        for (const auto& s : solids) meshes.push_back(mesh_of(s.solid));
        for (std::size_t i = 0; i < meshes.size(); ++i) parts.push_back({solids[i].name, &meshes[i]});
    }
};

std::string scratch_file(const std::string& suffix, const std::string& bytes) {
    const std::string path = (std::filesystem::temp_directory_path() / ("whittle_format_" + std::to_string(getpid()) + suffix)).string();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

}  // namespace

TEST_CASE("a solid is divided by part(), and what cuts all cuts each") {
    const Parts made;
    REQUIRE(made.parts.size() == 2);
    CHECK(made.parts[0].name == "bo<dy");
    CHECK(volume(made.meshes[0]) == Approx(1000 - 40));
    CHECK(volume(made.meshes[1]) == Approx((4 - 1) / 3.0));
}

TEST_CASE("3MF and AMF give back every part, name, colour and bit") {
    const Parts made;
    for (const MeshFormat format : {MeshFormat::k3mf, MeshFormat::kAmf}) {
        const auto file = write_mesh(made.parts, format);
        REQUIRE(file);
        CHECK(file->report.valid());
        CHECK(file->warnings.empty());
        const auto package = format == MeshFormat::k3mf ? read_3mf(file->bytes) : read_amf(file->bytes);
        if (!package) FAIL(package.error().message);
        REQUIRE(package->objects.size() == 2);
        CHECK(package->remarks.empty());
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(package->objects[i].name == made.parts[i].name);
            Mesh mesh = package->objects[i].mesh;
            mesh.leaf.clear();
            CHECK(mesh.points == made.meshes[i].mesh.points);
            CHECK(mesh.triangles == made.meshes[i].mesh.triangles);
        }
        CHECK(package->objects[0].color == Vec4(1, 0, 0, 1));
        REQUIRE(package->objects[1].color);
        CHECK(package->objects[1].color->w == Approx(0.5).epsilon(0.01));
        CHECK(write_mesh(made.parts, format)->bytes == file->bytes);
    }
}

#ifdef WHITTLE_LIB3MF
TEST_CASE("lib3mf reads our 3MF without a warning: millimetres, two closed meshes with their names") {
    const Parts made;
    const auto file = write_mesh(made.parts, MeshFormat::k3mf);
    REQUIRE(file);
    const std::string path = scratch_file(".3mf", file->bytes);
    using namespace NMR;
    PLib3MFModel* model = nullptr;
    PLib3MFModelReader* reader = nullptr;
    REQUIRE(lib3mf_createmodel(&model) == 0);
    REQUIRE(lib3mf_model_queryreader(model, "3mf", &reader) == 0);
    REQUIRE(lib3mf_reader_readfromfileutf8(reader, path.c_str()) == 0);
    DWORD warnings = 99, unit = 99;
    CHECK(lib3mf_reader_getwarningcount(reader, &warnings) == 0);
    CHECK(warnings == 0);
    CHECK(lib3mf_model_getunit(model, &unit) == 0);
    CHECK(unit == static_cast<DWORD>(MODELUNIT_MILLIMETER));
    PLib3MFModelResourceIterator* objects = nullptr;
    REQUIRE(lib3mf_model_getmeshobjects(model, &objects) == 0);
    std::size_t count = 0;
    for (BOOL more = 0; lib3mf_resourceiterator_movenext(objects, &more) == 0 && more;) {
        PLib3MFModelResource* object = nullptr;
        REQUIRE(lib3mf_resourceiterator_getcurrent(objects, &object) == 0);
        DWORD triangles = 0;
        BOOL manifold = 0;
        char name[64] = {};
        ULONG length = 0;
        CHECK(lib3mf_meshobject_gettrianglecount(object, &triangles) == 0);
        CHECK(lib3mf_meshobject_ismanifoldandoriented(object, &manifold) == 0);
        CHECK(lib3mf_object_getnameutf8(object, name, sizeof name, &length) == 0);
        CHECK(triangles == made.meshes.at(count).mesh.triangles.size());
        CHECK(manifold != 0);
        CHECK(std::string(name) == made.parts.at(count).name);
        ++count;
        lib3mf_release(object);
    }
    CHECK(count == 2);
    lib3mf_release(objects);
    lib3mf_release(reader);
    lib3mf_release(model);
    std::filesystem::remove(path);
}
#endif

TEST_CASE("OpenMesh reads our .om with every bit of the points and the colours") {
    struct Traits : OpenMesh::DefaultTraits {
        using Point = OpenMesh::Vec3d;
        FaceAttributes(OpenMesh::Attributes::Color);
    };
    const Parts made;
    const auto file = write_mesh(made.meshes[0], MeshFormat::kOm);
    REQUIRE(file);
    const std::string path = scratch_file(".om", file->bytes);
    OpenMesh::TriMesh_ArrayKernelT<Traits> mesh;
    OpenMesh::IO::Options options(OpenMesh::IO::Options::FaceColor);
    REQUIRE(OpenMesh::IO::read_mesh(mesh, path, options));
    CHECK(mesh.n_faces() == made.meshes[0].mesh.triangles.size());
    CHECK(mesh.n_edges() == mesh.n_faces() / 2 * 3);
    REQUIRE(mesh.n_vertices() == made.meshes[0].mesh.points.size());
    for (std::size_t i = 0; i < mesh.n_vertices(); ++i)
        for (int k = 0; k < 3; ++k) CHECK(mesh.point(mesh.vertex_handle(static_cast<unsigned>(i)))[static_cast<std::size_t>(k)] == made.meshes[0].mesh.points[i][k]);
    CHECK(mesh.color(mesh.face_handle(0)) == OpenMesh::Vec3uc(255, 0, 0));
    std::filesystem::remove(path);
}

TEST_CASE("a glTF's lengths add up and its parts are closed in float32") {
    const Parts made;
    const auto file = write_mesh(made.parts, MeshFormat::kGlb);
    REQUIRE(file);
    const std::string& b = file->bytes;
    const auto number = [&](std::size_t at) {
        std::uint32_t x = 0;
        std::memcpy(&x, b.data() + at, 4);
        return x;
    };
    CHECK(b.substr(0, 4) == "glTF");
    CHECK(number(4) == 2);
    CHECK(number(8) == b.size());
    const std::uint32_t json = number(12);
    CHECK(json % 4 == 0);
    CHECK(20 + json + 8 + number(20 + json) == b.size());
    const std::string text = b.substr(20, json);
    CHECK(text.find("\"name\":\"pin\"") != std::string::npos);
    CHECK(text.find("\"alphaMode\":\"BLEND\"") != std::string::npos);
    CHECK(text.find("\"byteLength\":" + std::to_string(number(20 + json)) + "}]}") != std::string::npos);
    CHECK(write_mesh(made.parts, MeshFormat::kGlb)->bytes == b);
}

TEST_CASE("an OBJ names a material a colour, and the file beside it has them") {
    const Parts made;
    const auto file = write_mesh(made.parts, MeshFormat::kObj, "thing.mtl");
    REQUIRE(file);
    CHECK(file->bytes.find("mtllib thing.mtl\n") != std::string::npos);
    CHECK(file->bytes.find("o pin\n") != std::string::npos);
    CHECK(file->bytes.find("usemtl color_ff0000ff\n") != std::string::npos);
    CHECK(file->materials == "newmtl color_ff0000ff\nKd 1 0 0\nd 1\nnewmtl color_0000ff80\nKd 0 0 1\nd " + std::string("0.5019607843137255\n"));
    const auto read = read_mesh(file->bytes, "thing.obj");
    REQUIRE(read);
    CHECK(mass_properties(*read).volume == Approx(961));
}

namespace {

// Has every edge two triangles, one each way?
bool is_manifold(const std::vector<Triangle>& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    return std::all_of(edges.begin(), edges.end(), [&](const auto& e) { return e.second == 1 && edges.count({e.first.second, e.first.first}) == 1; });
}

}  // namespace

TEST_CASE("parts that touch along an edge keep points of their own: every edge has two facets") {
    SolidBuilder b;
    const NodeId box = b.shape(shape::Box{Vec3(0), Vec3(1)});
    Use root;
    root.node = b.combine(SetOp::kUnion, {at(box), at(box, {1, 1, 0}), at(box, {0, 1, 1})});
    const Mesh mesh = mesh_of(b.finish(root)).mesh;
    REQUIRE(report_mesh(mesh).shared_edges > 0);
    const Mesh own = with_own_points(mesh);
    CHECK(own.triangles.size() == mesh.triangles.size());
    CHECK(is_manifold(own.triangles));
    CHECK(own.points.size() == 24);  // three boxes apart
}

TEST_CASE("where two pits meet along an edge within a block, the edge gets a point in its middle, and every edge has two facets") {
    SolidBuilder b;
    const NodeId block = b.shape(shape::Box{Vec3(-3), Vec3(3)}), pit = b.shape(shape::Box{Vec3(0), Vec3(1)});
    Use root;
    root.node = b.combine(SetOp::kDifference, {at(block), at(pit), at(pit, {-1, -1, 0})});
    const MeshResult made = mesh_of(b.finish(root));
    CHECK(made.report.valid());
    CHECK(made.report.self_intersections == 0U);
    CHECK(made.report.shared_edges == 2);  // halves
    CHECK(volume(made) == Approx(214));
    CHECK(is_manifold(with_own_points(made.mesh).triangles));
    CHECK(is_manifold(in_single_precision(made.mesh).triangles));
    Mesh twice = made.mesh;
    CHECK(divide_knots(twice) == 0);
    CHECK(twice == made.mesh);
}

TEST_CASE("an archive unpacks to what was packed, and says what is damaged") {
    const std::vector<ZipEntry> entries{{"a/b.txt", std::string(5000, 'x') + "end"}, {"empty", ""}, {"noise", "\x01\x02\xFF"}};
    const std::string bytes = zip_archive(entries);
    const auto zip = ZipReader::open(bytes);
    REQUIRE(zip);
    for (const auto& entry : entries) CHECK(*zip->read(entry.name) == entry.bytes);
    CHECK_FALSE(zip->read("b"));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::string cut = bytes.substr(0, i);
        const auto part = ZipReader::open(cut);
        if (!part) continue;
        for (const auto& entry : entries) CHECK_FALSE((part->read(entry.name) && part->read(entry.name)->size() > entry.bytes.size()));
    }
}
