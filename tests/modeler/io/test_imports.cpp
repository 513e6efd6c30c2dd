// test_imports.cpp — what the readers make of files as people have them: whole, broken, lying.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "csg/solid/polyhedron.h"
#include "modeler/io/dxf.h"
#include "modeler/io/file_imports.h"
#include "modeler/mesh/zip.h"

using namespace whittle;

namespace {

class Folder {
public:
    Folder() { std::filesystem::create_directories(path_); }
    ~Folder() { std::filesystem::remove_all(path_); }
    std::string file(const std::string& name, const std::string& bytes) const {
        const std::string path = (path_ / name).string();
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }

private:
    std::filesystem::path path_ = std::filesystem::temp_directory_path() / ("whittle_imports_" + std::to_string(getpid()));
};

ImportedMesh mesh_of(const std::string& name, const std::string& bytes) {
    const Folder folder;
    FileImports imports;
    auto read = imports.mesh(folder.file(name, bytes));
    if (!read) FAIL(read.error().message);
    return std::move(*read);
}
std::string fault_of(const std::string& name, const std::string& bytes) {
    const Folder folder;
    FileImports imports;
    const auto read = imports.mesh(folder.file(name, bytes));
    REQUIRE_FALSE(read);
    return read.error().message;
}
Drawing drawing_of(const std::string& name, const std::string& text, const DrawingRequest& request = {}) {
    const Folder folder;
    FileImports imports;
    auto read = imports.drawing(folder.file(name, text), request);
    if (!read) FAIL(read.error().message);
    return std::move(*read);
}
bool says(const std::vector<std::string>& remarks, const std::string& part) {
    for (const auto& remark : remarks)
        if (remark.find(part) != std::string::npos) return true;
    return false;
}

// Triangles of the box [lo, hi], outward, as lines of an OFF body.
struct Off {
    std::string points, faces;
    int n = 0, m = 0;
    void box(double lo, double hi, bool inward = false, int without = -1) {
        for (int i = 0; i < 8; ++i) points += std::to_string(i & 1 ? hi : lo) + " " + std::to_string(i & 2 ? hi : lo) + " " + std::to_string(i & 4 ? hi : lo) + "\n";
        const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (int q = 0; q < 6; ++q) {
            if (q == without) continue;
            faces += "4";
            for (int k = 0; k < 4; ++k) faces += " " + std::to_string(n + quads[q][inward ? 3 - k : k]);
            faces += "\n";
            ++m;
        }
        n += 8;
    }
    std::string text() const { return "OFF\n" + std::to_string(n) + " " + std::to_string(m) + " 0\n" + points + faces; }
};

double volume_of(const ImportedMesh& mesh) {
    double sum = 0;
    for (const auto& solid : mesh.solids) sum += signed_volume(*solid.mesh);
    return sum;
}

std::string stl(std::uint32_t promised, std::uint32_t written, float x = 1) {
    std::string bytes(80, ' ');
    bytes.append(reinterpret_cast<const char*>(&promised), 4);
    for (std::uint32_t i = 0; i < written; ++i) {
        const float f[12] = {0, 0, 1, 0, 0, 0, x, 0, 0, 0, 1, 0};
        bytes.append(reinterpret_cast<const char*>(f), sizeof f);
        bytes.append(2, '\0');
    }
    return bytes;
}

}  // namespace

TEST_CASE("a closed mesh comes in as it is") {
    Off off;
    off.box(0, 10);
    const ImportedMesh mesh = mesh_of("a.off", off.text());
    REQUIRE(mesh.solids.size() == 1);
    CHECK(mesh.remarks.empty());
    CHECK(open_edges(*mesh.solids[0].mesh) == 0);
    CHECK(volume_of(mesh) == 1000);
}

TEST_CASE("a hole is closed on its border and said") {
    Off off;
    off.box(0, 10, false, 1);
    const ImportedMesh mesh = mesh_of("a.off", off.text());
    CHECK(volume_of(mesh) == 1000);
    CHECK(open_edges(*mesh.solids.at(0).mesh) == 0);
    CHECK(says(mesh.remarks, "4 open edges around 1 holes"));
}

TEST_CASE("a mesh inside out is turned, a shell within another that faces inward is a cavity") {
    Off out;
    out.box(0, 10, true);
    const ImportedMesh turned = mesh_of("a.off", out.text());
    CHECK(volume_of(turned) == 1000);
    CHECK(says(turned.remarks, "inside out"));
    Off hollow;
    hollow.box(0, 10);
    hollow.box(2, 4, true);
    const ImportedMesh mesh = mesh_of("a.off", hollow.text());
    CHECK(volume_of(mesh) == 1000 - 8);
    CHECK(mesh.solids.size() == 1);
    CHECK(mesh.remarks.empty());
}

TEST_CASE("shells stuck into each other are solids of their own") {
    Off off;
    off.box(0, 10);
    off.box(5, 15);
    const ImportedMesh mesh = mesh_of("a.off", off.text());
    REQUIRE(mesh.solids.size() == 2);
    CHECK(volume_of(mesh) == 2000);
}

TEST_CASE("facets listed twice, turned facets and borders a rounding apart are mended") {
    Off twice;
    twice.box(0, 10);
    twice.faces += "4 4 5 7 6\n";
    ++twice.m;
    const ImportedMesh once = mesh_of("a.off", twice.text());
    CHECK(volume_of(once) == 1000);
    CHECK(says(once.remarks, "2 facets were there twice"));

    Off turned;
    turned.box(0, 10, false, 1);
    turned.faces += "4 6 7 5 4\n";
    ++turned.m;
    const ImportedMesh right = mesh_of("a.off", turned.text());
    CHECK(volume_of(right) == 1000);
    CHECK(says(right.remarks, "2 facets faced the other way"));

    Off split;
    split.box(0, 10, false, 1);
    split.points += "0 0 10.0000001\n10 0 10\n0 10 10\n10 10.0000001 10\n";
    split.n += 4;
    split.faces += "4 8 9 11 10\n";
    ++split.m;
    const ImportedMesh joined = mesh_of("a.off", split.text());
    CHECK(volume_of(joined) == Approx(1000).epsilon(1e-7));
    CHECK(says(joined.remarks, "2 points on open borders joined"));
}

TEST_CASE("a header that promises more than the file has is a clear fault, not an allocation") {
    CHECK(fault_of("a.stl", stl(20000000, 3)).find("promises 20000000 facets, the file ends after 3") != std::string::npos);
    CHECK(fault_of("a.off", "OFF\n4000000000 12 0\n").find("4000000000 points") != std::string::npos);
    CHECK(fault_of("a.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n").find("more than the file has bytes") != std::string::npos);
    CHECK(fault_of("a.stl", "").find("empty") != std::string::npos);
}

TEST_CASE("a number that is none is named by its facet or point") {
    CHECK(fault_of("a.stl", stl(2, 2, std::numeric_limits<float>::quiet_NaN())).find("facet 1") != std::string::npos);
    CHECK(fault_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n").find("point 2") != std::string::npos);
    CHECK(fault_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n").find("face 1") != std::string::npos);
    CHECK(fault_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").find("facet 1") != std::string::npos);
}

TEST_CASE("any beginning of a good file is read or refused, never worse") {
    Off off;
    off.box(0, 10);
    const std::string text = off.text(), binary = stl(4, 4);
    const Folder folder;
    FileImports imports;
    std::size_t refused = 0;
    for (std::size_t i = 0; i < text.size(); i += 7) refused += !imports.mesh(folder.file("a.off", text.substr(0, i)));
    for (std::size_t i = 0; i < binary.size(); i += 7) refused += !imports.mesh(folder.file("a.stl", binary.substr(0, i)));
    CHECK(refused > 40);
}

TEST_CASE("3MF: units, components, transforms, colours and names") {
    const std::string model = R"(<?xml version="1.0"?><model unit="inch" xmlns="x" xmlns:m="y"><resources>
<m:colorgroup id="5"><m:color color="#FF000080"/></m:colorgroup>
<object id="1" name="tetra" pid="5" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices>
<triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/></triangles></mesh></object>
<object id="2"><components><component objectid="1" transform="2 0 0 0 1 0 0 0 1 10 0 0"/></components></object></resources>
<build><item objectid="2"/><item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/></build></model>)";
    const std::string archive = zip_archive({{"3D/3dmodel.model", model}});
    const ImportedMesh mesh = mesh_of("a.3mf", archive);
    REQUIRE(mesh.solids.size() == 2);
    const double inch = 25.4 * 25.4 * 25.4;
    CHECK(signed_volume(*mesh.solids[0].mesh) == Approx(2 * inch / 6));
    CHECK(signed_volume(*mesh.solids[1].mesh) == Approx(inch / 6));  // the mirror kept it outward
    CHECK(mesh.solids[0].name == "tetra");
    REQUIRE(mesh.solids[0].color);
    CHECK(mesh.solids[0].color->x == 1);
    CHECK(mesh.solids[0].color->w == Approx(128 / 255.0));
    CHECK(mesh.remarks.empty());
    CHECK(fault_of("a.3mf", archive.substr(0, archive.size() / 2)).find("not a whole zip") != std::string::npos);
    CHECK(fault_of("a.3mf", zip_archive({{"3D/3dmodel.model", "<model><build><item objectid=\"7\"/></build></model>"}})).find("no object '7'") != std::string::npos);
}

TEST_CASE("an archive's damage is found by its checksum, and a circle of components ends") {
    std::string archive = zip_archive({{"3D/3dmodel.model", std::string(2000, ' ') + "<model/>"}});
    archive[60] = static_cast<char>(archive[60] ^ 0x55);
    CHECK(fault_of("a.3mf", archive).find("damaged") != std::string::npos);
    const std::string circle = R"(<model><resources><object id="1"><components><component objectid="1"/></components></object></resources><build><item objectid="1"/></build></model>)";
    CHECK(fault_of("a.3mf", zip_archive({{"3D/3dmodel.model", circle}})).find("nested too deep") != std::string::npos);
}

TEST_CASE("AMF: volumes, units and colours, plain and packed") {
    const std::string amf = R"(<?xml version="1.0"?><amf unit="meter"><object id="0"><metadata type="name">t</metadata><mesh><vertices>
<vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex><vertex><coordinates><x>1e-3</x><y>0</y><z>0</z></coordinates></vertex>
<vertex><coordinates><x>0</x><y>1e-3</y><z>0</z></coordinates></vertex><vertex><coordinates><x>0</x><y>0</y><z>1e-3</z></coordinates></vertex></vertices>
<volume><color><r>0</r><g>1</g><b>0</b></color><triangle><v1>0</v1><v2>2</v2><v3>1</v3></triangle><triangle><v1>0</v1><v2>1</v2><v3>3</v3></triangle>
<triangle><v1>1</v1><v2>2</v2><v3>3</v3></triangle><triangle><v1>2</v1><v2>0</v2><v3>3</v3></triangle></volume></mesh></object></amf>)";
    for (const std::string& bytes : {amf, zip_archive({{"a.amf", amf}})}) {
        const ImportedMesh mesh = mesh_of("a.amf", bytes);
        REQUIRE(mesh.solids.size() == 1);
        CHECK(volume_of(mesh) == Approx(1.0 / 6));
        CHECK(mesh.solids[0].name == "t");
        CHECK(mesh.solids[0].color == Vec4(0, 1, 0, 1));
    }
}

TEST_CASE("SVG: circles and their arcs stay arcs, the sheet's lower left corner is the origin") {
    const Drawing drawing = drawing_of("a.svg", R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50">
<circle cx="10" cy="10" r="5"/><g transform="translate(20,0) rotate(90)"><path d="M0 0h10a5 5 0 0 1 0-10H0z"/></g><text>no</text></svg>)svg");
    REQUIRE(drawing.figures.size() == 2);
    CHECK(drawing.figures[0].contours[0].start == Vec2(15, 40));
    for (const auto& side : drawing.figures[0].contours[0].sides) CHECK(std::fabs(side.bulge) == Approx(1));
    int arcs = 0;
    for (const auto& side : drawing.figures[1].contours[0].sides) arcs += side.bulge != 0;
    CHECK(arcs == 1);
    CHECK(says(drawing.remarks, "1 elements"));
}

TEST_CASE("SVG: an ellipse becomes curves; with a viewBox a px is a 72nd of an inch unless dpi says otherwise, without one a unit is a millimetre") {
    DrawingRequest request;
    request.dpi = 25.4;
    const Drawing drawing = drawing_of("a.svg", R"(<svg width="10" height="10" viewBox="0 0 10 10"><ellipse cx="5" cy="5" rx="4" ry="2"/></svg>)", request);
    REQUIRE(drawing.figures.size() == 1);
    for (const auto& side : drawing.figures[0].contours[0].sides) CHECK(side.degree == 3);
    CHECK(drawing.figures[0].contours[0].start == Vec2(9, 5));
    const Drawing points = drawing_of("a.svg", R"(<svg width="72" height="72" viewBox="0 0 72 72"><path d="M0 0H72V72z"/></svg>)");
    CHECK(points.figures.at(0).contours.at(0).sides.at(0).end().x == Approx(25.4));
    const Drawing plain = drawing_of("a.svg", R"(<svg width="72" height="72"><path d="M0 0H72V72z"/></svg>)");
    CHECK(plain.figures.at(0).contours.at(0).sides.at(0).end() == Vec2(72, 25.4));
}

TEST_CASE("DXF: lines and arcs are joined by their ends, a polyline's bulges are arcs, blocks are inserted") {
    const std::string text =
        "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n0\nCIRCLE\n8\n0\n10\n1\n20\n0\n40\n0.5\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
        "0\nLINE\n8\nA\n10\n0\n20\n0\n11\n10\n21\n0\n0\nLINE\n8\nA\n10\n0\n20\n10\n11\n0\n21\n0\n"
        "0\nARC\n8\nA\n10\n0\n20\n0\n40\n10\n50\n0\n51\n90\n"
        "0\nLWPOLYLINE\n8\nP\n90\n2\n70\n1\n10\n20\n20\n0\n42\n1\n10\n22\n20\n0\n42\n1\n"
        "0\nINSERT\n8\n0\n2\nB\n10\n50\n20\n5\n41\n2\n42\n2\n0\nENDSEC\n0\nEOF\n";
    const Drawing all = drawing_of("a.dxf", text);
    REQUIRE(all.figures.size() == 1);
    CHECK(all.remarks.empty());
    REQUIRE(all.figures[0].contours.size() == 3);
    DrawingRequest layer;
    layer.layer = "A";
    layer.scale = 2;
    layer.origin = {1, 0};
    const Drawing a = drawing_of("a.dxf", text, layer);
    REQUIRE(a.figures.at(0).contours.size() == 1);
    const DrawnContour& pie = a.figures[0].contours[0];
    CHECK(pie.sides.size() == 3);
    CHECK(pie.start == Vec2(-2, 0));
    bool open = says(drawing_of("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nA\n10\n0\n20\n0\n11\n1\n21\n0\n0\nENDSEC\n0\nEOF\n").remarks, "1 outlines are open");
    CHECK(open);
}

TEST_CASE("DXF: blocks that stand in themselves or for millions of entities are told, not drawn") {
    const auto block = [](const std::string& name, const std::string& inside, int times) {
        std::string out = "0\nBLOCK\n2\n" + name + "\n0\nCIRCLE\n40\n1\n";
        for (int i = 0; i < times; ++i) out += "0\nINSERT\n2\n" + inside + "\n";
        return out + "0\nENDBLK\n";
    };
    const auto file = [](const std::string& blocks) {
        return "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nA\n0\nENDSEC\n0\nEOF\n";
    };
    const Drawing itself = drawing_of("a.dxf", file(block("A", "A", 3)));
    CHECK(itself.figures.at(0).contours.size() == 1);
    CHECK(says(itself.remarks, "3 entities INSERT passed over"));
    std::string deep;
    for (char name = 'A'; name < 'I'; ++name) deep += block(std::string(1, name), std::string(1, static_cast<char>(name + 1)), 10);
    const auto refused = read_dxf(file(deep), {});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "its blocks stand for more than 1000000 entities");
}

TEST_CASE("DXF: an arc too small for its place is no outline") {
    const Drawing none = drawing_of("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nARC\n10\n1e9\n20\n1e9\n40\n1e-9\n50\n0\n51\n90\n0\nENDSEC\n0\nEOF\n");
    CHECK(none.figures.empty());
    CHECK(none.remarks.empty());
}

TEST_CASE("height maps: rows of numbers, comments, and what is no number by its line") {
    const Folder folder;
    FileImports imports;
    const auto map = imports.heights(folder.file("a.dat", "# a map\n1 2 3\n\n4 5 6 # last\n"), false);
    REQUIRE(map);
    CHECK(map->columns == 3);
    CHECK(map->rows == 2);
    CHECK(map->z == std::vector<double>{1, 2, 3, 4, 5, 6});
    const auto wrong = imports.heights(folder.file("b.dat", "1 2\n3 x\n"), false);
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().message.find("line 2") != std::string::npos);
}
