// test_examples.cpp — every example states facts about itself, and spans and mesh both bear them out; with a dimension changed they do not.
#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "modeler/check/agreement.h"
#include "modeler/mesh/mesh_queries.h"
#include "modeler/check/facts.h"
#include "tests/examples/scenes.h"

using namespace whittle;
using namespace whittle::test;

namespace {

const std::string kFolder = WHITTLE_SOURCE_DIR "/examples";

// Enough for intervals of some 1e-4; a fact has room of three: by chance one in three million fails.
constexpr std::uint64_t kLines = 150'000;
constexpr double kIntervals = 3;
// Facts are written with twelve digits.
constexpr double kDigits = 1e-11;

Measurement measured(const Solid& solid, const Program& program) {
    MeasureOptions options;
    options.lines = kLines;
    const auto m = measure(solid, program, options);
    REQUIRE(m);
    return *m;
}

std::shared_ptr<const Program> compiled(const Solid& solid) {
    const auto program = compile(solid);
    REQUIRE(program);
    return *program;
}

bool holds(const Fact& fact, const Measured& m, double room) {
    return std::fabs(m.value - fact.value) <= kIntervals * m.error + (fact.within + kDigits) * std::fabs(fact.value) + room;
}

// The facts that spans can tell.
std::vector<std::string> failing(const Facts& facts, const Measurement& m) {
    std::vector<std::string> r;
    if (const auto f = facts.find("volume"); f && !holds(*f, m.volume, 0)) r.push_back("volume");
    if (const auto f = facts.find("area"); f && !holds(*f, m.area, 0)) r.push_back("area");
    return r;
}

// Coarse enough to be quick. Of a volume it takes at most tolerance times area. Of an area, chords take the share h / (3 r) on radius r, 6e-3 on the
// chain's wire, the thinnest; an edge where curved faces cross at an angle moves by h over its half angle's sine, the lens's by 2e-3 of its area.
constexpr double kTolerance = 0.03;
constexpr double kAreaShare = 1e-2;

}  // namespace

TEST_CASE("there are at least eighteen examples, and each states volume, genus, components and a perturbation") {
    const auto paths = scenes_in(kFolder);
    CHECK(paths.size() >= 18);
    for (const std::string& path : paths) {
        CAPTURE(path);
        const Facts facts = facts_of(text_of(path));
        CHECK(facts.malformed.empty());
        CHECK(facts.find("volume"));
        CHECK(facts.find("genus"));
        CHECK(facts.find("components"));
        CHECK(!facts.perturbation.empty());
    }
}

TEST_CASE("examples are read without a message and leave nothing out") {
    for (const std::string& path : scenes_in(kFolder)) {
        CAPTURE(path);
        const ReadScene scene = read_scene(path);
        CHECK(scene.messages == std::vector<std::string>{});
        CHECK_FALSE(scene.stopped);
        CHECK_FALSE(scene.canonical.something_left_out);
        CHECK_FALSE(scene.canonical.is_2d);
    }
}

TEST_CASE("spans bear out every example's facts, and not those of a changed dimension") {
    for (const std::string& path : scenes_in(kFolder)) {
        CAPTURE(path);
        const Facts facts = facts_of(text_of(path));
        const ReadScene scene = read_scene(path);
        const Measurement m = measured(scene.canonical.solid, *compiled(scene.canonical.solid));
        CAPTURE(m.volume.value, m.volume.error, m.area.value, m.area.error);
        CHECK(failing(facts, m) == std::vector<std::string>{});

        const ReadScene changed = read_scene(path, {facts.perturbation});
        const Measurement other = measured(changed.canonical.solid, *compiled(changed.canonical.solid));
        CAPTURE(facts.perturbation, other.volume.value, other.volume.error);
        CHECK(failing(facts, other) != std::vector<std::string>{});
    }
}

TEST_CASE("meshes bear out every example's facts and agree with the spans") {
    for (const std::string& path : scenes_in(kFolder)) {
        CAPTURE(path);
        const Facts facts = facts_of(text_of(path));
        const ReadScene scene = read_scene(path);
        MeshControl control;
        MeshOptions mesh_options;
        mesh_options.tolerance_mm = kTolerance;
        const auto made = mesh_solid(scene.canonical.solid, mesh_options, control);
        REQUIRE(made);
        CHECK(made->report.valid());
        AgreementOptions options;
        options.tolerance = made->tolerance_mm;
        options.rounding = made->grid_mm;
        options.lines = 2048;
        const auto a = check_agreement(scene.canonical.solid, *compiled(scene.canonical.solid), made->mesh, options);
        REQUIRE(a);
        CAPTURE(a->disagreements_in_all, a->worst.distance, a->worst.bound, a->volume_mesh.value, a->area_mesh.value);
        CHECK(a->agree);
        CHECK(a->genus == static_cast<int>(facts.find("genus")->value));
        CHECK(a->components == static_cast<int>(facts.find("components")->value));
        CHECK(holds(*facts.find("volume"), a->volume_mesh, (a->tolerance + a->rounding) * a->area_mesh.value));
        if (const auto area = facts.find("area")) CHECK(holds(*area, a->area_mesh, kAreaShare * area->value));
    }
}
