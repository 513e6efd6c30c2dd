// What the evaluator hands on: lights, lens, matter, roots, definitions, parameters, hints.
#include <catch2/catch.hpp>

#include "csg/eval/colors.h"
#include "csg/eval/survey_colors.h"
#include "tests/csg/eval/memory_files.h"

using namespace whittle;
using namespace whittle::test;

namespace {

template <class T>
const T* first(const Scene& scene) {
    constexpr bool kBoxed = std::is_same_v<T, scene::Matter> || std::is_same_v<T, scene::Moving>;
    for (const SceneNode& node : scene.nodes) {
        if constexpr (kBoxed) {
            if (const Boxed<T>* found = std::get_if<Boxed<T>>(&node.what)) return &found->get();
        } else {
            if (const T* found = std::get_if<T>(&node.what)) return found;
        }
    }
    return nullptr;
}

std::string hint_of(const std::string& text) {
    const Evaluated made = run(text);
    return made.diagnostics.all().empty() ? "" : made.diagnostics.all()[0].hint;
}

}  // namespace

TEST_CASE("lights stand where the transforms around them put them") {
    const Evaluated made = run("translate([10,0,0]) rotate(90) { light(p=[1,0,0], power=5, r=2); sun([1,0,0], angle=3); area_light(u=[2,0,0]); cube(); }");
    REQUIRE(made.scene.lights.size() == 3);
    const PointLight& point = std::get<PointLight>(made.scene.lights[0].what);
    CHECK(point.p == Vec3(10, 1, 0));
    CHECK(point.power == 5.0);
    CHECK(point.radius == 2);
    CHECK(std::get<SunLight>(made.scene.lights[1].what).direction == Vec3(0, 1, 0));
    CHECK(std::get<AreaLight>(made.scene.lights[2].what).u == Vec3(0, 2, 0));
    CHECK(made.diagnostics.all().empty());
}

TEST_CASE("every evaluation makes a light; modifiers remove it") {
    CHECK(run("for (i=[0:4]) light([i,0,0]);").scene.lights.size() == 5);
    CHECK(run("*light(); %light(); %union() { light(); } #light();").scene.lights.size() == 1);
    const Evaluated rooted = run("light([1,0,0]); !union() { light([2,0,0]); cube(); } light([3,0,0]);");
    REQUIRE(rooted.scene.lights.size() == 1);
    CHECK(std::get<PointLight>(rooted.scene.lights[0].what).p.x == 2);
}

TEST_CASE("the last camera wins, with a warning") {
    const Evaluated made = run("camera([1,2,3], fov=30); translate([1,0,0]) camera(eye=[5,5,5], target=[0,0,1], aperture=2, projection=\"orthographic\");");
    REQUIRE(made.scene.camera);
    CHECK(made.scene.camera->eye == Vec3(6, 5, 5));
    CHECK(made.scene.camera->target == Vec3(1, 0, 1));
    CHECK(made.scene.camera->aperture == 2);
    CHECK(made.scene.camera->orthographic);
    CHECK(made.diagnostics.count(Severity::kWarning) == 1);
}

TEST_CASE("material takes a preset and named parameters") {
    const Evaluated made = run("material(\"glass\", roughness=0.2, color=\"red\", absorption=[1,2,3], ior=1.6) sphere(1);");
    const scene::Matter* matter = first<scene::Matter>(made.scene);
    REQUIRE(matter);
    CHECK(matter->material.preset == std::string("glass"));
    CHECK(matter->material.roughness == 0.2);
    CHECK(matter->material.color == Vec4(1, 0, 0, 1));
    CHECK(matter->material.absorption == Vec3(1, 2, 3));
    CHECK_FALSE(matter->material.metal);
    CHECK(made.diagnostics.all().empty());
    const Evaluated wrong = run("material(\"glas\") sphere(1);");
    CHECK(wrong.diagnostics.has_errors());
    CHECK(wrong.diagnostics.all()[0].text.find("presets are matte, plastic, glass") != std::string::npos);
    CHECK(wrong.diagnostics.all()[0].hint == "did you mean \"glass\"?");
}

TEST_CASE("the solids that OpenSCAD lacks keep their sizes") {
    CHECK(first<scene::Torus>(run("torus(5, d2=2);").scene)->r2 == 1);
    CHECK(first<scene::Ellipsoid>(run("ellipsoid([1,2,3]);").scene)->r == Vec3(1, 2, 3));
    CHECK(first<scene::HalfSpace>(run("halfspace([0,1,0], 4);").scene)->d == 4);
    CHECK(first<scene::Quadric>(run("quadric([1,2,3,4,5,6,7,8,9,10]);").scene)->c[9] == 10);
    CHECK(first<scene::Capsule>(run("capsule([0,0,0],[0,0,5],2);").scene)->q.z == 5);
    CHECK(first<scene::RoundCube>(run("roundcube([1,2,3], 0.1, true);").scene)->center);
    CHECK(first<scene::Part>(run("part(\"lid\") cube();").scene)->name == "lid");
    CHECK(first<scene::Moving>(run("moving(translate=[1,0,0]) cube();").scene)->end == Placement::translation({1, 0, 0}));
}

TEST_CASE("an author's own definition hides a built-in one") {
    CHECK(csg_of("module torus(r1, r2) { cube(r1); } torus(3, 1);") == "group() {\n\tcube(size = [3, 3, 3], center = false);\n}\n\n");
    CHECK(echo_of("function sin(x) = \"mine\"; echo(sin(1));") == "ECHO: \"mine\"\n");
}

TEST_CASE("only the first root is left") {
    const Evaluated made = run("cube(1); union() { !sphere(2); } !cube(3);");
    const SceneNode& root = made.scene.nodes[made.scene.root];
    REQUIRE(root.children.size() == 1);
    CHECK(std::get<scene::Sphere>(made.scene.nodes[root.children[0]].what).r == 2);
    CHECK(made.diagnostics.all()[0].text == "More than one Root Modifier (!)");
}

TEST_CASE("definitions of the command line overwrite without a warning") {
    EvaluateInput input;
    input.definitions = {"a=5", "s=\"x\"", "$fn=7"};
    CHECK(echo_of("a = 1; s = \"y\"; echo(a, s, $fn);", input) == "ECHO: 5, \"x\", 7\n");
    input.definitions = {"a="};
    CHECK(run("a = 1;", input).stop == Stop::kSyntax);
}

TEST_CASE("a parameter set beats definitions and takes the kind of the value it replaces") {
    EvaluateInput input;
    input.definitions = {"w=5"};
    input.parameters = {{"w", "99"}, {"v", "[4, 5, 6]"}, {"flag", "false"}, {"s", "12"}, {"unknown", "1"}, {"bad", "x"}};
    CHECK(echo_of("w=1; v=[1,2,3]; flag=true; s=\"a\"; bad=3; echo(w,v,flag,s,bad);", input) == "ECHO: 99, [4, 5, 6], false, \"12\", 3\n");
}

TEST_CASE("libraries are searched beside the file, then in the library folders") {
    EvaluateInput input;
    input.path = "work/main.scad";
    input.library_paths = {"lib1", "lib2"};
    const std::map<std::string, std::string> files{{"work/near.scad", "x=1;"}, {"lib2/far.scad", "y=2;"}, {"lib2/sub/deep.scad", "include <side.scad>"},
                                                   {"lib2/sub/side.scad", "z=3;"}};
    const Evaluated made = run("include <near.scad>\ninclude <far.scad>\ninclude <sub/deep.scad>\necho(x, y, z);", input, files);
    CHECK(echo_text(made.diagnostics, made.sources) == "ECHO: 1, 2, 3\n");
    CHECK(made.files_read == std::vector<std::string>{"work/main.scad", "work/near.scad", "lib2/far.scad", "lib2/sub/deep.scad", "lib2/sub/side.scad"});
}

TEST_CASE("a file of the name whittle.scad is read as an empty one") {
    CHECK(echo_of("include <whittle.scad>\nuse <lib/whittle.scad>\necho(1);") == "ECHO: 1\n");
}

TEST_CASE("view variables of the file are handed on") {
    const Evaluated made = run("$vpr = [10,20,30]; $vpd = 200; $vpt = \"a\";");
    CHECK(made.scene.view.rotation_deg == Vec3(10, 20, 30));
    CHECK(made.scene.view.distance == 200.0);
    CHECK_FALSE(made.scene.view.target);
    CHECK_FALSE(made.scene.view.fov_deg);
    CHECK(made.diagnostics.all()[0].text == "Unable to convert $vpt=\"a\" to a vec3 or vec2 of numbers");
}

TEST_CASE("an unknown name is answered with the nearest known one") {
    CHECK(hint_of("height = 5; echo(heigth);") == "did you mean 'height'?");
    CHECK(hint_of("echo(sqtr(2));") == "did you mean 'sqrt'?");
    CHECK(hint_of("cyllinder(h=1);") == "did you mean 'cylinder'?");
    CHECK(hint_of("module wheel() {} wheal();") == "did you mean 'wheel'?");
    CHECK(hint_of("color(\"bleu\") cube();") == "did you mean \"blue\"?");
    CHECK(hint_of("zzzzzz();").empty());
    CHECK(hint_of("diff() cube(1);") == "did you mean 'difference'?");
    CHECK(hint_of("Cube(1);") == "did you mean 'cube'?");
    CHECK(hint_of("cube(1, center = TRUE);") == "did you mean 'true'?");
}

TEST_CASE("what other languages call otherwise is answered with its name here") {
    CHECK(hint_of("print(1);") == "did you mean 'echo'?");
    CHECK(hint_of("x = None;") == "did you mean 'undef'?");
    CHECK(hint_of("if (false) cube(1); elseif (true) cube(2);") == "'else if' is two words");
    CHECK(hint_of("cube(10mm);") == "numbers have no units: '10mm' is read as a name");
    CHECK(hint_of("x = cube(1);") == "'cube' is a module: it makes a body, which is no value");
    CHECK(hint_of("function f() = 1; f();") == "'f' is a function: it makes a value, not a body");
    CHECK(hint_of("module print() {} prin();") == "did you mean 'print'?");
    CHECK(hint_of("x = 1 + \"a\";") == "texts are joined by str(a, b)");
    CHECK(hint_of("cube(1) cube(2);") == "is a ';' missing behind cube(...)?");
}

TEST_CASE("a wrong argument is answered with the signature") {
    CHECK(hint_of("cube(1, foo=2);") == "expected cube(size, center)");
    CHECK(hint_of("sphere(1, fn=20);") == "did you mean '$fn'? expected sphere(r) or sphere(d=)");
    CHECK(hint_of("sphere(diameter=2);") == "did you mean 'd'? expected sphere(r) or sphere(d=)");
    CHECK(hint_of("echo(sin(1,2));") == "expected sin(degrees) -> number");
    CHECK(hint_of("module wheel(r, width) {} wheel(1, widht=2);") == "did you mean 'width'? expected wheel(r, width)");
    CHECK(hint_of("function f(a, b=1) = a; echo(f(1, 2, 3));") == "expected f(a, b)");
    CHECK(hint_of("f = function(x) x; echo(f(1, y=2));") == "expected f(x)");
    CHECK(hint_of("translate(\"a\") cube(1);") == "expected translate([x, y, z])");
    CHECK(hint_of("rotate(\"a\") cube(1);") == "expected rotate([x, y, z]) or rotate(angle, axis)");
    CHECK(hint_of("cube(\"a\");") == "expected cube(size, center)");
    CHECK(hint_of("polygon([[0, 0], [1, true]]);") == "expected polygon(points, paths, convexity)");
}

TEST_CASE("bit operators and hexadecimal numbers are there") {
    CHECK(echo_of("echo(0xFF, 6 & 3, 6 | 3, 1 << 4, 256 >> 4, ~0, 1 | 2 & 3);") == "ECHO: 255, 2, 7, 16, 16, -1, 3\n");
    CHECK(echo_of("echo(1 & \"a\");") == "WARNING: undefined operation (number & string) in file main.scad, line 1\nECHO: undef\n");
}

TEST_CASE("parse and evaluate are two steps over one input") {
    MemoryFiles files;
    EvaluateInput input;
    input.path = "a.scad";
    input.text = "echo(1); cube(2);";
    Result<Parsed> parsed = parse(input, files);
    REQUIRE(parsed);
    REQUIRE(parsed->program);
    const Parsed again = *parsed;
    CHECK(evaluate(std::move(*parsed), input, files).scene.nodes.size() == 2);
    CHECK(evaluate(again, input, files).scene.nodes.size() == 2);
}

TEST_CASE("powers of small whole numbers are exact") {
    for (int base = 2; base <= 10; ++base) {
        double exact = 1;
        for (int exponent = 0; exponent <= 15; ++exponent, exact *= base) {
            const std::string text = "echo(pow(" + std::to_string(base) + "," + std::to_string(exponent) + ")==" + std::to_string(static_cast<long long>(exact)) + ");";
            INFO(text);
            CHECK(echo_of(text) == "ECHO: true\n");
        }
    }
}

TEST_CASE("an extrusion of a file leaves out what stands under it") {
    CHECK(csg_of("linear_extrude(\"a.dxf\", height = 2) square(1);").find("square") == std::string::npos);
    CHECK(csg_of("rotate_extrude(file = \"a.dxf\") square(1);").find("square") == std::string::npos);
    CHECK(csg_of("linear_extrude(height = 2) square(1);").find("square") != std::string::npos);
}

TEST_CASE("a file that is no text is named as it is shown") {
    CHECK(csg_of("import(5);").find("import(file = \"5\"") != std::string::npos);
    CHECK(csg_of("import();").find("import(file = \"\"") != std::string::npos);
}

TEST_CASE("names of the colour survey are known by their prefix, in any case, and told where they nearly are") {
    const auto sorted = survey_colors();
    CHECK(sorted.size() == 949);
    for (std::size_t i = 1; i < sorted.size(); ++i) CHECK(sorted[i - 1].name < sorted[i].name);
    CHECK(color_of_text("xkcd:windows blue") == Vec4(0x37 / 255.0, 0x78 / 255.0, 0xBF / 255.0, 1));
    CHECK(color_of_text("XKCD:Blue/Green") == Vec4(0x0F / 255.0, 0x9B / 255.0, 0x8E / 255.0, 1));
    CHECK(color_of_text("blue") == Vec4(0, 0, 1, 1));
    CHECK_FALSE(color_of_text("windows blue"));
    CHECK_FALSE(color_of_text("xkcd:"));
    CHECK(nearest_color("xkcd:windws blue") == "did you mean \"xkcd:windows blue\"?");
}
