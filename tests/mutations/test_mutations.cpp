// test_mutations.cpp — the tests bite: an engine with a planted fault is found out.
//
// This program holds an engine of its own, compiled with WHITTLE_MUTATIONS (tracer/engine/mutation.h). Three watchmen look at it: the exact reference on
// random solids, the laws of sets where operands coincide but are written differently, and light through a glass shell of 1e-9 of its own size.
#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <cstdlib>

#include "tests/stress/compare.h"
#include "tests/support/seed.h"
#include "tests/support/use.h"
#include "tracer/engine/mutation.h"

namespace whittle {

Mutation present_mutation = Mutation::kNone;

}  // namespace whittle

using namespace whittle;
using namespace whittle::stress;
using namespace whittle::support;

namespace {

struct Planted {
    explicit Planted(Mutation m) { present_mutation = m; }
    ~Planted() { present_mutation = Mutation::kNone; }
    Planted(const Planted&) = delete;
    Planted& operator=(const Planted&) = delete;
};

// What the reference says against the engine on a few random solids of every theme; empty where nothing.
std::string reference_says(std::uint64_t seed, int solids) {
    std::mt19937_64 random(seed);
    Scratch scratch;
    Tally tally;
    for (int i = 0; i < solids; ++i) {
        const RandomSolid solid = random_solid(static_cast<Theme>(i % kThemes), random());
        const Subject subject = subject_of(solid.solid, true);
        if (!subject.program) continue;
        for (int k = 0; k < 10; ++k) {
            const Ray ray = random_ray(solid, random);
            std::string why = disagreement(subject, ray, scratch, random, tally);
            if (why.empty()) why = continuation_disagreement(subject, ray, scratch, random, tally);
            if (!why.empty()) return why;
        }
    }
    return {};
}

// A box, a ball and a cylinder less themselves, turned by 30 and 30 instead of 60 degrees: is anything left on any ray?
std::string laws_say(std::uint64_t seed) {
    const Shape shapes[] = {shape::Box{{0.1, 0.2, 0.3}, {1.1, 1.3, 1.7}}, shape::Frustum{-1, 1, 0.7, 0.7}, shape::Frustum{-1, 1, 0.7, 0.2}};
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-2, 2);
    for (const Shape& s : shapes) {
        SolidBuilder b({false, false, false});
        const NodeId a = b.combine(SetOp::kUnion, {use(b.shape(s), Placement::translation({0.3, 0.1, 0}))});
        const Use once = use(a, turned_about_z(60)), twice = use(b.combine(SetOp::kUnion, {use(a, turned_about_z(30))}), turned_about_z(30));
        const auto program = compile(b.finish(use(b.combine(SetOp::kDifference, {once, twice}))));
        if (!program) return "does not compile";
        Scratch scratch;
        Spans spans;
        for (int i = 0; i < 300; ++i) {
            Ray ray;
            ray.origin = {uniform(random), uniform(random), uniform(random)};
            ray.direction = 0.3 * Vec3(uniform(random), uniform(random), uniform(random)) - ray.origin;
            all_spans(**program, ray, scratch, spans);
            if (!spans.empty()) return "something is left of A - A";
        }
    }
    return {};
}

// A ray goes straight on through a shell, from border to border: it has to meet four.
std::string shell_says() {
    for (const double size : {1e-6, 1.0, 1e6}) {
        SolidBuilder b;
        const NodeId outer = b.shape(shape::Ellipsoid{Vec3(size)}), inner = b.shape(shape::Ellipsoid{Vec3(size * (1 - 1e-9))});
        const auto program = compile(b.finish(use(b.combine(SetOp::kDifference, {use(outer), use(inner)}))));
        if (!program) return "does not compile";
        Ray ray;
        ray.origin = Vec3(-3, 0.2, 0.1) * size;
        ray.direction = {1, 0, 0};
        Scratch scratch;
        Hit hit;
        Departure departure;
        int met = 0;
        while (met < 10 && first_hit(**program, ray, HUGE_VAL, scratch, hit)) {
            ++met;
            departure = hit.departure;
            ray.origin = hit.point;
            ray.departure = &departure;
        }
        if (met != 4) return "the shell has " + std::to_string(met) + " borders";
    }
    return {};
}

}  // namespace

TEST_CASE("an engine without a planted fault raises no alarm") {
    CHECK(reference_says(fresh_seed(), 100) == "");
    CHECK(laws_say(1) == "");
    CHECK(shell_says() == "");
}

TEST_CASE("the reference finds an engine without error bounds, exact tier, the rule for rays in faces, or with an epsilon") {
    const auto mutation = GENERATE(Mutation::kNoBounds, Mutation::kNoExactTier, Mutation::kRayEpsilon, Mutation::kReversedRule, Mutation::kEpsilonContinuation);
    const Planted planted(mutation);
    INFO("mutation " << static_cast<int>(mutation));
    CHECK(reference_says(7, 1000) != "");
}

TEST_CASE("the laws of sets find an engine whose primitives have surfaces of their own") {
    const Planted planted(Mutation::kOwnIdentity);
    CHECK(laws_say(1) != "");
}

TEST_CASE("a glass shell of 1e-9 finds an engine that leaves surfaces by an epsilon") {
    const Planted planted(Mutation::kEpsilonContinuation);
    CHECK(shell_says() != "");
}

// WHITTLE_SEARCH_S=300: looks for rays on which a border has no cause in any box that its t lies in; what it finds belongs into test_found.cpp.
TEST_CASE("no border lacks a cause in the boxes that its t lies in", "[.search]") {
    const Planted planted(Mutation::kCausesInBoxesOnly);
    const char* seconds = std::getenv("WHITTLE_SEARCH_S");
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds == nullptr ? 60 : std::atoi(seconds));
    std::mt19937_64 random(fresh_seed());
    Scratch scratch;
    int found = 0;
    while (std::chrono::steady_clock::now() < end && found < 5) {
        const Theme theme = std::array{Theme::kThin, Theme::kLadder, Theme::kFar, Theme::kWedge}[random() % 4];
        const std::uint64_t recipe = random();
        const RandomSolid solid = random_solid(theme, recipe);
        const auto program = compile(solid.solid);
        if (!program) continue;
        for (int i = 0; i < 40; ++i) {
            Ray ray = random_ray(solid, random);
            Hit hit;
            Spans spans;
            Departure departure;
            const auto bad = [&](const End& e) { return e.use >= leaf_uses(**program).size(); };
            for (int k = 0; k < 4; ++k) {
                if (!first_hit(**program, ray, HUGE_VAL, scratch, hit)) break;
                all_spans(**program, ray, scratch, spans);
                bool wrong = bad(hit.end);
                for (const Span& s : spans) wrong = wrong || (s.in && bad(*s.in)) || (s.out && bad(*s.out));
                if (wrong) {
                    ++found;
                    WARN(name_of(theme) << " " << recipe << "u ray " << to_text(ray) << " departures " << (ray.departure == nullptr ? 0 : departure.count));
                    break;
                }
                departure = hit.departure;
                if (departure.count == 6) break;
                std::uniform_real_distribution<double> within(-1, 1);
                ray.origin = hit.point;
                ray.departure = &departure;
                ray.direction = {within(random), within(random), within(random)};
            }
        }
    }
    CHECK(found == 0);
}
