// --summary and --summary-file: what a run made, in the words and members of OpenSCAD's later versions.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/modeler/cli/run_program.h"


namespace {

constexpr const char* kCubes = "cube([2, 3, 4]); translate([5, 0, 0]) cube(1);";

nlohmann::json summary_of(const std::string& text, const std::string& output, std::vector<std::string> options) {
    const TemporaryFolder folder;
    const std::string scene = folder.file("s.scad", text);
    options.insert(options.end(), {"-o", folder.name(output), "--summary-file", folder.name("s.json"), scene});
    const Outcome outcome = run_whittle(options);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return nlohmann::json::parse(folder.read("s.json"));
}

}  // namespace

TEST_CASE("a summary file tells of the mesh, the box, the camera and the time") {
    const nlohmann::json s = summary_of(kCubes, "a.stl", {});
    CHECK(s["geometry"]["dimensions"] == 3);
    CHECK(s["geometry"]["simple"] == true);
    CHECK(s["geometry"]["vertices"] == 16);
    CHECK(s["geometry"]["edges"] == 36);
    CHECK(s["geometry"]["facets"] == 24);
    CHECK(s["geometry"]["components"] == 2);
    CHECK(s["geometry"]["genus"] == 0);
    CHECK(s["geometry"]["bounding_box"] == nlohmann::json::parse(R"({"min":[0,0,0],"max":[6,3,4],"size":[6,3,4]})"));
    CHECK(s["geometry"]["area"] == 58);
    CHECK(s["time"]["total"].get<int>() >= 0);
    CHECK(s["cache"]["geometry_cache"]["entries"].get<int>() > 0);
    CHECK(s["camera"]["fov"].get<double>() == Approx(22.5));
}

TEST_CASE("a summary of some topics holds only these") {
    const nlohmann::json s = summary_of(kCubes, "a.off", {"--summary", "bounding-box", "--summary=time"});
    CHECK(s.size() == 2);
    CHECK(s["geometry"].size() == 2);
    CHECK(s["geometry"]["bounding_box"]["size"] == std::vector<double>{6, 3, 4});
    CHECK(s.contains("time"));
}

TEST_CASE("a summary of a drawing has contours, arcs counted into its box and area") {
    const nlohmann::json s = summary_of("difference() { circle(5); circle(1); }", "a.svg", {});
    CHECK(s["geometry"]["dimensions"] == 2);
    CHECK(s["geometry"]["contours"] == 2);
    CHECK(s["geometry"]["bounding_box"]["max"] == std::vector<double>{5, 5});
    CHECK(s["geometry"]["area"].get<double>() == Approx(24 * 3.141592653589793));
}

TEST_CASE("the camera of a summary is the gimbal that --camera takes") {
    const std::string seven = "--camera=1,2,3,40,50,60,70";
    const nlohmann::json given = summary_of(kCubes, "a.stl", {seven})["camera"];
    const std::vector<double> translation{1, 2, 3}, rotation{40, 50, 60};
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(given["translation"][i].get<double>() == Approx(translation[i]));
        CHECK(given["rotation"][i].get<double>() == Approx(rotation[i]));
    }
    CHECK(given["distance"].get<double>() == Approx(70));
    const nlohmann::json six = summary_of(kCubes, "a.stl", {"--camera=0,-10,0,0,0,0", "--projection=o"})["camera"];
    CHECK(six["rotation"][0].get<double>() == Approx(90));
    CHECK(six["rotation"][2].get<double>() == Approx(0).margin(1e-12));
    CHECK(six["distance"].get<double>() == Approx(10));
    CHECK(six["fov"].get<double>() == Approx(22.5));
    const nlohmann::json set = summary_of("$vpr = [10, 0, 30]; $vpd = 99; cube(1);", "a.stl", {})["camera"];
    CHECK(set["rotation"][0].get<double>() == Approx(10));
    CHECK(set["distance"].get<double>() == Approx(99));
}

TEST_CASE("without a file the summary is plain lines") {
    const TemporaryFolder folder;
    const std::string scene = folder.file("s.scad", kCubes);
    const Outcome outcome = run_whittle({"-o", folder.name("a.stl"), "--summary", "all", scene});
    CHECK(outcome.code == 0);
    for (const char* line : {"Geometries in cache: ", "Total rendering time: 0:00:0", "Top level object is a 3D object:", "   Simple:        yes\n", "   Vertices:       16\n",
                             "Bounding box:\n   Min:  0.00, 0.00, 0.00\n   Max:  6.00, 3.00, 4.00\n   Size: 6.00, 3.00, 4.00\n", "   Area: 58.00\n", "   FOV:         22.50\n"})
        CHECK(contains(outcome.err, line));
    const Outcome picture = run_whittle({"-o", folder.name("a.png"), "--imgsize=8,8", "--summary", "bounding-box", "--summary-file", "-", scene});
    CHECK(picture.code == 0);
    CHECK(picture.out == "{\"geometry\":{\"dimensions\":3,\"bounding_box\":{\"min\":[0,0,0],\"max\":[6,3,4],\"size\":[6,3,4]}}}\n");
}
