// Renderings that end early: the picture so far, the checkpoint, and the way on to the bits of one that never stopped.
#include <catch2/catch.hpp>

#include "run_program.h"

namespace {

const char* const kScene = "difference() { cube(10, center = true); sphere(6.4); cylinder(h = 30, r = 2, center = true); }\n";

using Words = std::vector<std::string>;

// Draws in a folder; what all runs share stands first.
struct Studio {
    TemporaryFolder folder;
    RunOptions there{"", folder.path().string(), 0, ""};
    Studio() { folder.file("a.scad", kScene); }
    Outcome draw(const std::string& picture, Words more, double interrupt_after_s = 0) const {
        Words words{"render", "a.scad", "--imgsize", "90,70", "-o", picture};
        words.insert(words.end(), more.begin(), more.end());
        RunOptions options = there;
        options.interrupt_after_s = interrupt_after_s;
        return run_whittle(words, options);
    }
};

}  // namespace

TEST_CASE("a rendering stopped by time goes on to the bytes of one that never stopped") {
    const Studio studio;
    for (const Words& more : {Words{"--samples", "12"}, Words{"--samples", "40", "--noise", "0.02"}, Words{"--samples", "6", "--aov", "depth,normal,variance", "--exr", "float"},
                              Words{"--samples", "12", "--shard", "2/3", "--tile", "10,5,70,60"}}) {
        const std::string format = more.size() > 4 && more[2] == "--aov" ? ".exr" : ".png";
        REQUIRE(studio.draw("whole" + format, more).code == 0);
        Words stopping = more;
        stopping.insert(stopping.end(), {"--stop-after", "0.000001"});
        const Outcome stopped = studio.draw("parts" + format, stopping);
        CHECK(stopped.code == 0);
        CHECK(contains(stopped.err, "--resume goes on from parts" + format + ".part"));
        CHECK(studio.folder.read("parts" + format) != studio.folder.read("whole" + format));
        stopping.emplace_back("--resume");
        CHECK(studio.draw("parts" + format, stopping).code == 0);
        Words going_on = more;
        going_on.emplace_back("--resume");
        CHECK(studio.draw("parts" + format, going_on).code == 0);
        CHECK(studio.folder.read("parts" + format) == studio.folder.read("whole" + format));
        CHECK(!std::filesystem::exists(studio.folder.name("parts" + format + ".part")));
    }
}

TEST_CASE("an interrupt leaves the whole picture and the checkpoint, again and again") {
    const Studio studio;
    const Words endless{"--samples", "1000000"};
    CHECK(studio.draw("a.png", endless, 1.0).code == 130);
    CHECK(studio.folder.names() == Words{"a.png", "a.png.part", "a.scad"});
    const std::string first = studio.folder.read("a.png.part");
    CHECK(studio.draw("a.png", {"--samples", "1000000", "--resume"}, 1.0).code == 130);
    CHECK(studio.folder.read("a.png.part") != first);
}

TEST_CASE("nothing is resumed from another scene, other options or a damaged checkpoint") {
    const Studio studio;
    const Words few{"--samples", "9", "--stop-after", "0.000001"};
    REQUIRE(studio.draw("a.png", few).code == 0);
    const std::string part = studio.folder.read("a.png.part"), picture = studio.folder.read("a.png");
    for (const Words& other : {Words{"--samples", "10"}, Words{"--samples", "9", "--seed", "2"}, Words{"--samples", "9", "-D", "x=1"}, Words{"--samples", "9", "--filter", "box"},
                               Words{"--samples", "9", "--camera", "0,0,0,10,20,30,90"}}) {
        Words words = other;
        words.emplace_back("--resume");
        const Outcome refused = studio.draw("a.png", words);
        CHECK(refused.code == 2);
        CHECK(contains(refused.err, "Can't resume from 'a.png.part': it is of another scene or of other options"));
    }
    CHECK(studio.folder.read("a.png") == picture);
    studio.folder.file("a.scad", std::string(kScene) + "cube(1);\n");
    CHECK(studio.draw("a.png", {"--samples", "9", "--resume"}).code == 2);
    studio.folder.file("a.scad", kScene);
    studio.folder.file("a.png.part", part.substr(0, part.size() - 1));
    CHECK(studio.draw("a.png", {"--samples", "9", "--resume"}).code == 3);
    CHECK(studio.folder.read("a.png") == picture);
}

TEST_CASE("a flat scene is drawn as a thin sheet") {
    const Studio studio;
    studio.folder.file("a.scad", "difference() { square(20, center = true); circle(5); }\n");
    CHECK(studio.draw("flat.png", {"--samples", "2"}).code == 0);
    studio.folder.file("a.scad", "translate([0, 0, -0.01]) linear_extrude(0.02) difference() { square(20, center = true); circle(5); }\n");
    CHECK(studio.draw("solid.png", {"--samples", "2"}).code == 0);
    CHECK(studio.folder.read("flat.png") == studio.folder.read("solid.png"));
    studio.folder.file("a.scad", "square(0);\n");
    CHECK(studio.draw("none.png", {}).code == 1);
}

TEST_CASE("without a checkpoint --resume begins, and a finished picture takes only a checkpoint away") {
    const Studio studio;
    const Outcome fresh = studio.draw("a.png", {"--samples", "2", "--resume"});
    CHECK(fresh.code == 0);
    CHECK(contains(fresh.err, "nothing to resume"));
    studio.folder.file("a.png.part", "somebody's notes");
    CHECK(studio.draw("a.png", {"--samples", "2"}).code == 0);
    CHECK(studio.folder.read("a.png.part") == "somebody's notes");
    CHECK(studio.draw("-", {"--export-format", "png", "--resume"}).code == 2);
}
