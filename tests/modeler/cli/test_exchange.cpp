// test_exchange.cpp — files in and out of the program, and what other programs make of them.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <catch2/catch.hpp>

#include "modeler/mesh/mesh_files.h"
#include "modeler/mesh/mesh_queries.h"
#include "run_program.h"
#include "tracer/image/image_file.h"

using namespace whittle;

namespace {

constexpr const char* kTetra = "OFF\n4 4 0\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
constexpr const char* kOpenscad = "/usr/bin/openscad";
constexpr const char* kPovray = "/usr/bin/povray";

Mesh mesh_in(const TemporaryFolder& folder, const std::string& name) {
    const auto mesh = read_mesh(folder.read(name), name);
    if (!mesh) FAIL(mesh.error().message);
    return *mesh;
}
double volume_in(const TemporaryFolder& folder, const std::string& name) { return mass_properties(mesh_in(folder, name)).volume; }

}  // namespace

TEST_CASE("an imported mesh is traced, and stands beside the text that names it") {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "parts");
    folder.file("parts/tetra.off", kTetra);
    folder.file("parts/tetra.scad", "module tetra() import(\"tetra.off\");\n");
    const std::string scene = folder.file("main.scad", "use <parts/tetra.scad>\ntetra();\n");
    const Outcome spans = run_whittle({"spans", scene, "--ray=1,1,-5,0,0,1", "--json", "-d", folder.name("main.d")});
    REQUIRE(spans.code == 0);
    CHECK(contains(spans.out, R"("in":{"t":5,)"));
    CHECK(contains(spans.out, R"("out":{"t":9,)"));
    CHECK(contains(spans.out, R"("file":"parts/tetra.scad","line":1)"));
    CHECK(contains(folder.read("main.d"), "parts/tetra.off"));
}

TEST_CASE("a file that is not there is said and nothing is written") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "import(\"nothing.stl\");\ncube(1);\n");
    const Outcome made = run_whittle({"mesh", scene, "-o", folder.name("a.stl")});
    CHECK(made.code == 1);
    CHECK(contains(made.err, "WARNING: Can't open import file 'nothing.stl'"));
    CHECK(contains(made.err, "line 1"));
    CHECK_FALSE(std::filesystem::exists(folder.path() / "a.stl"));
    const std::string other = folder.file("b.scad", "import(\"thing.xyz\");\nsurface(\"nothing.dat\");\n");
    const Outcome refused = run_whittle({"mesh", other, "-o", folder.name("b.stl")});
    CHECK(refused.code == 1);
    CHECK(contains(refused.err, "Unsupported file format"));
    CHECK(contains(refused.err, "Can't open surface file 'nothing.dat'"));
}

TEST_CASE("a gigabyte that claims to be an STL ends at the memory limit") {
    const TemporaryFolder folder;
    std::string head(84, '\0');
    const std::uint32_t count = 21474834;
    std::memcpy(head.data() + 80, &count, 4);
    folder.file("huge.stl", head);
    std::filesystem::resize_file(folder.path() / "huge.stl", 84 + std::uintmax_t{50} * count);
    const std::string scene = folder.file("huge.scad", "import(\"huge.stl\");\n");
    const Outcome made = run_whittle({"mesh", scene, "-o", folder.name("out.stl"), "--limit-memory", "200"});
    CHECK(made.code == 3);
    CHECK(contains(made.err, "memory limit"));
    std::filesystem::resize_file(folder.path() / "huge.stl", 200);
    const Outcome lies = run_whittle({"mesh", scene, "-o", folder.name("out.stl"), "--limit-memory", "200"});
    CHECK(lies.code == 1);
    CHECK(contains(lies.err, "the header promises 21474834 facets, the file ends after 2"));
    CHECK(folder.names() == std::vector<std::string>{"huge.scad", "huge.stl"});
}

TEST_CASE("several outputs of one run, all of the same solid; the same bytes on any number of threads") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "color(\"red\") difference() { cube(10); translate([5, 5, -1]) cylinder(h = 12, r = 3); }\n");
    const std::vector<std::string> kinds{"stl", "off", "obj", "ply", "3mf", "amf", "glb", "om", "pov"};
    const auto write = [&](const std::string& stem, const char* threads) {
        std::vector<std::string> words{scene, "--threads", threads};
        for (const auto& kind : kinds) words.insert(words.end(), {"-o", folder.name(stem + "." + kind)});
        return run_whittle(words);
    };
    REQUIRE(write("one", "1").code == 0);
    REQUIRE(write("two", "3").code == 0);
    for (const auto& kind : kinds) {
        const std::string one = folder.read("one." + kind);
        CHECK(one.size() > 200);
        if (kind != "obj") CHECK(one == folder.read("two." + kind));  // an OBJ names its materials
    }
    CHECK(contains(folder.read("one.mtl"), "Kd 1 0 0"));
    CHECK(volume_in(folder, "one.off") == volume_in(folder, "one.ply"));
}

TEST_CASE("a file a part") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", "difference() { union() { part(\"a/b\") cube(4); part(\"c\") translate([4, 0, 0]) cube(2); } translate([-1, 1, 1]) cube([9, 1, 1]); }\n");
    const Outcome made = run_whittle({"mesh", scene, "-o", folder.name("x-{part}.off"), "-o", folder.name("all.off")});
    REQUIRE(made.code == 0);
    CHECK(volume_in(folder, "x-a_b.off") == Approx(60));
    CHECK(volume_in(folder, "x-c.off") == Approx(6));
    CHECK(volume_in(folder, "all.off") == Approx(66));
}

TEST_CASE("2D sets become drawings, solids do not; drawings come back") {
    const TemporaryFolder folder;
    const std::string flat = folder.file("flat.scad", "difference() { offset(r = 2) square([20, 10]); translate([5, 5]) circle(3); }\n");
    const Outcome made = run_whittle({"-o", folder.name("f.svg"), "-o", folder.name("f.dxf"), "-o", folder.name("f.pdf"), flat});
    REQUIRE(made.code == 0);
    CHECK(contains(folder.read("f.svg"), " A 3 3 "));
    CHECK(contains(folder.read("f.dxf"), "CIRCLE"));
    CHECK(folder.read("f.pdf").rfind("%PDF", 0) == 0);
    const double area = 200 + 2 * 60 + 4 * 3.141592653589793 - 9 * 3.141592653589793;
    for (const char* name : {"f.svg", "f.dxf"}) {
        const std::string again = folder.file("again.scad", std::string("linear_extrude(2) import(\"") + name + "\");\n");
        REQUIRE(run_whittle({"mesh", again, "-o", folder.name("again.off"), "--tolerance", "0.0005"}).code == 0);
        CHECK(volume_in(folder, "again.off") == Approx(2 * area).epsilon(1e-3));
    }
    const std::string solid = folder.file("solid.scad", "cube(1);\n");
    const Outcome refused = run_whittle({"-o", folder.name("s.svg"), solid});
    CHECK(refused.code == 1);
    CHECK(contains(refused.err, "Current top level object is not a 2D object."));
    CHECK_FALSE(std::filesystem::exists(folder.path() / "s.svg"));
    const Outcome mesh = run_whittle({"-o", folder.name("s.stl"), flat});
    CHECK(mesh.code == 1);
    CHECK(contains(mesh.err, "Current top level object is not a 3D object."));
}

TEST_CASE("extrusions read the drawing they name, dimensions and crossings are numbers") {
    const TemporaryFolder folder;
    folder.file("a.dxf",
                "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nA\n10\n0\n20\n0\n11\n4\n21\n0\n0\nLINE\n8\nA\n10\n4\n20\n0\n11\n4\n21\n3\n0\nLINE\n8\nA\n10\n4\n20\n3\n11\n0\n21\n0\n"
                "0\nLINE\n8\nX\n10\n0\n20\n0\n11\n2\n21\n2\n0\nLINE\n8\nX\n10\n0\n20\n2\n11\n2\n21\n0\n"
                "0\nDIMENSION\n8\nD\n1\nwide\n70\n0\n13\n1\n23\n0\n14\n8\n24\n5\n50\n0\n0\nENDSEC\n0\nEOF\n");
    const std::string scene = folder.file("a.scad", "echo(dxf_dim(file = \"a.dxf\", name = \"wide\"), dxf_cross(file = \"a.dxf\", layer = \"X\"), dxf_dim(file = \"a.dxf\", name = \"none\"));\n"
                                                    "linear_extrude(file = \"a.dxf\", layer = \"A\", height = 5);\n");
    const Outcome made = run_whittle({"mesh", scene, "-o", folder.name("a.off")});
    REQUIRE(made.code == 0);
    CHECK(contains(made.err, "ECHO: 7, [1, 1], undef"));
    CHECK(contains(made.err, "Can't find dimension 'none'"));
    CHECK(volume_in(folder, "a.off") == Approx(30));
}

TEST_CASE("surface() and files of the openscad package give its volumes") {
    if (!std::filesystem::exists(kOpenscad)) return;
    const TemporaryFolder folder;
    folder.file("h.dat", "1 2 3 2\n0 -1 4 2\n2 2 2 2\n");
    folder.file("f.scad", "surface(\"h.dat\", center = true);\n");
    const std::string examples = "/usr/share/openscad/examples/";
    for (const std::string& scene : {folder.name("f.scad"), examples + "Old/example008.scad", examples + "Old/example010.scad", examples + "Advanced/surface_image.scad"}) {
        INFO(scene);
        REQUIRE(run_whittle({"mesh", scene, "-o", folder.name("ours.off"), "--curves=faceted"}).code == 0);
        REQUIRE(run_program(kOpenscad, {"-o", folder.name("theirs.off"), scene}).code == 0);
        const Mesh ours = mesh_in(folder, "ours.off"), theirs = mesh_in(folder, "theirs.off");
        CHECK(mass_properties(ours).volume == Approx(mass_properties(theirs).volume).epsilon(2e-5));
        const Bounds a = mesh_bounds(ours), b = mesh_bounds(theirs);
        CHECK(glm::length(a.lo - b.lo) + glm::length(a.hi - b.hi) < 2e-4 * glm::length(b.hi - b.lo));
    }
}

namespace {

struct PicturesApart {
    double mean = 0, far_share = 0;  // of a channel; of pixels that differ by more than a tenth
};

// How far POV-Ray's picture of the .pov of matt solids under one lamp is from ours.
PicturesApart by_povray(const std::string& solids) {
    const TemporaryFolder folder;
    const std::string scene = folder.file("a.scad", R"(
sun(direction = [-1, 0.5, -1]);
environment(color = [0, 0, 0]);
camera(eye = [60, -80, 70], target = [0, 0, 0], fov = 30);
material("matte") {
)" + solids + "}\n");
    REQUIRE(run_whittle({"render", scene, "-o", folder.name("ours.png"), "--imgsize", "240,180", "--samples", "16"}).code == 0);
    REQUIRE(run_whittle({"-o", folder.name("a.pov"), scene, "--imgsize", "240,180"}).code == 0);
    RunOptions there;
    there.folder = folder.path().string();
    REQUIRE(run_program(kPovray, {"+Ia.pov", "+Otheirs.png", "+W240", "+H180", "-D", "+A0.05", "+R3", "-GA"}, there).code == 0);
    ImageFiles files(WHITTLE_BUILD_DIR);
    const auto ours = files.read(folder.path() / "ours.png"), theirs = files.read(folder.path() / "theirs.png");
    REQUIRE(ours);
    REQUIRE(theirs);
    PicturesApart sum;
    const std::size_t pixels = static_cast<std::size_t>(ours->width) * static_cast<std::size_t>(ours->height), n = ours->channels.size(), m = theirs->channels.size();
    for (std::size_t i = 0; i < pixels; ++i) {
        double apart = 0;
        for (std::size_t c = 0; c < 3; ++c) apart = std::max(apart, std::fabs(static_cast<double>(ours->floats[i * n + c]) - static_cast<double>(theirs->floats[i * m + c])));
        sum.mean += apart / static_cast<double>(pixels);
        sum.far_share += (apart > 0.1 ? 1 : 0) / static_cast<double>(pixels);
    }
    return sum;
}

void check_alike_by_povray(const std::string& solids) {
    if (!std::filesystem::exists(kPovray)) return;
    // At edges the two average over different pixels.
    constexpr double kMean = 0.01, kFarShare = 0.03;
    const PicturesApart apart = by_povray(solids);
    CHECK(apart.mean < kMean);
    CHECK(apart.far_share < kFarShare);
}

}  // namespace

TEST_CASE("POV-Ray draws our .pov as we draw the scene") {
    check_alike_by_povray(R"(
    color("orangered") difference() { cube(30, center = true); sphere(19); cylinder(h = 40, r = 6, center = true); }
    color("skyblue") translate([0, 0, 20]) torus(10, 3);
    color("white") translate([-25, 0, -10]) rotate_extrude() translate([6, 0]) square([3, 12]);
    color("lime") translate([25, 0, -15]) linear_extrude(20) difference() { circle(8); square(6); }
    color("gold") translate([0, -25, -12]) capsule([0, 0, 0], [10, 0, 10], 4);
    color("white") translate([0, 0, -20]) cube([120, 120, 4], center = true);
)");
}

TEST_CASE("POV-Ray cuts what is flush, and shows the colours that we show") {
    check_alike_by_povray(R"(
    // Flush bores, and a cutter within a cutter whose faces show the body.
    color("orangered") translate([-14, 0, 0]) difference() {
        cube(20, center = true);
        difference() { cube([12, 12, 20], center = true); cylinder(h = 20, r = 4, center = true); }
    }
    color("skyblue") translate([14, 0, 0]) rotate([0, 0, 30]) difference() {
        cylinder(h = 16, r = 10);
        cylinder(h = 16, r = 6);
        color("gold") translate([-10, -3, 8]) cube([20, 6, 8]);
    }
    // Two colours claim one face: the first written shows.
    translate([0, -22, 0]) { color("lime") cube(8); color("white") translate([4, 0, 0]) cube([8, 8, 8]); }
    translate([0, 22, 16]) scale([1, 1, 2]) intersection() { cube(10, center = true); translate([2, 0, 0]) cube([10, 10, 5], center = true); }
    color("white") translate([0, 0, -14]) cube([120, 120, 4], center = true);
)");
}

TEST_CASE("a library folder of OPENSCADPATH holds files that scenes import") {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "library/meshes");
    std::filesystem::create_directory(folder.path() / "work");
    folder.file("library/meshes/t.off", kTetra);
    const std::string scene = folder.file("work/a.scad", "import(\"meshes/t.off\", center = true);\n");
    const char* before = std::getenv("OPENSCADPATH");
    const std::string kept = before ? before : "";
    setenv("OPENSCADPATH", folder.name("library").c_str(), 1);
    const Outcome spans = run_whittle({"spans", scene, "--ray=-2,-2,-9,0,0,1", "--json"});
    if (before) setenv("OPENSCADPATH", kept.c_str(), 1);
    else unsetenv("OPENSCADPATH");
    REQUIRE(spans.code == 0);
    CHECK(contains(spans.out, R"("point":[-2,-2,-3])"));
}

TEST_CASE("segments give the facets that OpenSCAD's development version makes") {
    // Volumes of its files (2025, Manifold, six digits a coordinate).
    const std::pair<const char*, double> cases[] = {
        {"linear_extrude(5, twist=90, slices=4, segments=16) square(4);", 80.521307},
        {"linear_extrude(5, twist=90, slices=4, segments=0) square([4,2]);", 45.363096},
        {"linear_extrude(5, scale=[1,3], slices=5, segments=22) square([6,2]);", 120},
        {"linear_extrude(8, twist=-200, scale=[2,0.5], slices=12, segments=40) difference() { square(6,center=true); translate([1,0]) square(2,center=true); }", 276.11664},
        {"linear_extrude(5, twist=60, scale=2, slices=6, segments=13) polygon([[0,0],[4,1],[2,5]]);", 105.571755},
        {"linear_extrude(10, [3,0,4], twist=45, slices=3, segments=9) square(2);", 33.016867},
    };
    for (const auto& [text, volume] : cases) {
        INFO(text);
        const TemporaryFolder folder;
        REQUIRE(run_whittle({"mesh", folder.file("s.scad", text), "-o", folder.name("a.off")}).code == 0);
        CHECK(volume_in(folder, "a.off") == Approx(volume).epsilon(1e-4));
    }
}
