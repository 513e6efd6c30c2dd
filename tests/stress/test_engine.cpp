// test_engine.cpp — the engine against the exact reference on random solids and adversarial rays; fresh seeds in each run, printed on failure.
//
// Both read the same formula (lowered.h), so nothing is masked: every border, every t within its bound, on solids snapped and not.
#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <cstdlib>

#include "tests/stress/compare.h"
#include "tests/support/reduce.h"
#include "tests/support/seed.h"

using namespace whittle;
using namespace whittle::stress;
using namespace whittle::support;

namespace {

struct Disagreement {
    std::string text;
};

std::string fault_of(const Solid& solid, bool snap, const Ray& ray) {
    const Subject subject = subject_of(solid, snap);
    if (!subject.program) return {};
    Scratch scratch;
    std::mt19937_64 random(1);
    Tally tally;
    const std::string why = disagreement(subject, ray, scratch, random, tally);
    return why.empty() ? continuation_disagreement(subject, ray, scratch, random, tally) : why;
}

// What differs, on the smallest solid on which it does, ready to become a test.
std::string report(Theme theme, std::uint64_t seed, bool snap, const Solid& solid, const Ray& ray, const std::string& why) {
    const Solid small = reduced(solid, [&](const Solid& s) { return !fault_of(s, snap, ray).empty(); });
    return std::string(name_of(theme)) + " " + std::to_string(seed) + "u snap " + (snap ? "on" : "off") + " ray " + to_text(ray) + "\n  " + why + "\n  reduced: " +
           fault_of(small, snap, ray) + "\n  " + to_code(small);
}

// Pairs of a ray and a solid that holds a shape of the kind, by kind.
using KindCounts = std::array<std::uint64_t, std::variant_size_v<Shape> + 1>;
constexpr auto kKindNames = std::to_array<const char*>({"box", "ellipsoid", "frustum", "torus", "half-space", "quadric", "capsule", "round box", "convex body",
                                                       "faceted ball", "faceted frustum", "polyhedron", "extrusion", "revolution", "disc", "rectangle", "polygon", "parabola", "section"});
static_assert(kKindNames.size() == std::tuple_size_v<KindCounts>);

void count_kinds(const Solid& solid, std::uint64_t pairs, KindCounts& counts) {
    std::array<bool, std::tuple_size_v<KindCounts>> seen{};
    for (NodeId id = 0; id < solid.node_count(); ++id)
        if (const auto* shape = std::get_if<Shape>(&solid.node(id))) {
            const auto* polygon = std::get_if<shape::Polygon>(shape);
            seen[polygon && polygon->section != kEmptyNode ? kKindNames.size() - 1 : shape->index()] = true;
        }
    for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += seen[k] ? pairs : 0;
}

// Compares on one random solid; returns what differs.
std::vector<Disagreement> disagreements(Theme theme, std::uint64_t seed, int rays, Tally& tally, KindCounts& kinds) {
    std::mt19937_64 random(seed);
    const RandomSolid solid = random_solid(theme, seed);
    const bool snap = seed % 2 == 0;
    const Subject subject = subject_of(solid.solid, snap);
    std::vector<Disagreement> found;
    if (!subject.program) {
        ++tally.not_compiled;
        return {};
    }
    count_kinds(solid.solid, static_cast<std::uint64_t>(rays), kinds);
    Scratch scratch;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = random_ray(solid, random);
        std::string why = disagreement(subject, ray, scratch, random, tally);
        if (why.empty()) why = continuation_disagreement(subject, ray, scratch, random, tally);
        if (why.empty()) continue;
        found.push_back({report(theme, seed, snap, solid.solid, ray, why)});
        return found;
    }
    return found;
}

}  // namespace

TEST_CASE("the engine agrees with the exact reference") {
    const std::uint64_t seed = fresh_seed();
    WARN("WHITTLE_SEED=" << seed);
    std::mt19937_64 seeds(seed);
    KindCounts kinds{};
    for (int theme = 0; theme < kThemes; ++theme) {
        Tally tally;
        for (int i = 0; i < 50; ++i)
            for (const Disagreement& d : disagreements(static_cast<Theme>(theme), seeds(), 20, tally, kinds)) {
                INFO(d.text);
                CHECK(false);
            }
        INFO(name_of(static_cast<Theme>(theme)));
        CHECK(tally.borders > tally.pairs / 4);
        CHECK(tally.continued > tally.pairs / 20);
        CHECK(tally.uncertified == 0);
        CHECK(tally.not_compiled <= 20);
        CHECK(tally.undecided * 2 < tally.body_rays + 100);
        CHECK(tally.loose * 6 < tally.body_rays + 100);
    }
}

// WHITTLE_SOAK_S=600 test_stress [soak]: as many solids as fit; every disagreement is printed.
TEST_CASE("the engine agrees with the exact reference for as long as asked", "[.soak]") {
    const char* seconds = std::getenv("WHITTLE_SOAK_S");
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds ? std::atoi(seconds) : 60);
    const std::uint64_t seed = fresh_seed();
    WARN("WHITTLE_SEED=" << seed);
    std::mt19937_64 seeds(seed);
    std::vector<Tally> tallies(kThemes);
    KindCounts kinds{};
    int failures = 0;
    while (std::chrono::steady_clock::now() < end && failures < 50)
        for (int theme = 0; theme < kThemes; ++theme)
            for (const Disagreement& d : disagreements(static_cast<Theme>(theme), seeds(), 60, tallies[static_cast<std::size_t>(theme)], kinds)) {
                ++failures;
                WARN(d.text);
            }
    for (int theme = 0; theme < kThemes; ++theme) {
        const Tally& t = tallies[static_cast<std::size_t>(theme)];
        WARN(name_of(static_cast<Theme>(theme)) << ": " << t.pairs << " pairs, " << t.borders << " borders, " << t.from_inside << " from inside, " << t.continued << " continued, worst error/bound "
                                                << t.worst_ratio << ", not compiled " << t.not_compiled);
        if (t.body_rays > 0) WARN("  with convex bodies " << t.body_rays << ", undecided " << t.undecided << ", of which other borders " << t.loose);
    }
    for (std::size_t k = 0; k < kinds.size(); ++k) WARN(kKindNames[k] << ": " << kinds[k] << " pairs");
    CHECK(failures == 0);
}
