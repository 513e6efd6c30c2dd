// passes_test.cpp — each pass of the engine switched off: the same answers to the bit, and more work.
#include <catch2/catch.hpp>

#include <cstring>

#include "csg/base/passes.h"
#include "tests/support/random_solid.h"
#include "tests/tracer/engine/rays.h"
#include "tracer/engine/engine.h"

using namespace whittle;
using namespace whittle::support;
using namespace whittle::testing;

namespace {

// All that a ray is told, as bytes.
class Record {
public:
    template <class T>
    void add(const T& value) {
        static_assert(std::is_arithmetic_v<T>);
        const auto at = bytes.size();
        bytes.resize(at + sizeof value);
        std::memcpy(&bytes[at], &value, sizeof value);
    }
    void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
    void add(const End& e) { add(e.t), add(e.t_error), add(e.normal), add(e.surface), add(e.use), add(e.certified); }
    void add(const Hit& h) {
        add(h.end), add(h.point), add(h.from_inside), add(h.departure.count);
        for (std::size_t i = 0; i < static_cast<std::size_t>(h.departure.count); ++i) add(h.departure.classes[i]);
    }
    std::string bytes;
};

// Bit i of `queries`: 0 first hits in packets, 1 alone, 2 any hits in packets, 3 alone, 4 all spans.
std::string answers(const Program& program, const std::vector<Ray>& rays, double t_max, unsigned queries, EngineCounters& counters) {
    Scratch scratch;
    Record record;
    const auto n = rays.size();
    std::vector<Hit> hits(n);
    const auto found = std::make_unique<bool[]>(n);
    const auto add = [&](bool is, const Hit& hit) {
        record.add(is);
        if (is) record.add(hit);
    };
    if (queries & 1) {
        first_hits(program, rays.data(), static_cast<int>(n), t_max, scratch, hits.data(), found.get());
        for (std::size_t i = 0; i < n; ++i) add(found[i], hits[i]);
    }
    if (queries & 2)
        for (std::size_t i = 0; i < n; ++i) {
            const bool is = first_hit(program, rays[i], t_max, scratch, hits[i]);
            add(is, hits[i]);
        }
    if (queries & 4) {
        const std::vector<double> far(n, t_max);
        any_hits(program, rays.data(), far.data(), static_cast<int>(n), scratch, found.get());
        for (std::size_t i = 0; i < n; ++i) record.add(found[i]);
    }
    for (std::size_t i = 0; (queries & 8) && i < n; ++i) record.add(any_hit(program, rays[i], t_max, scratch));
    Spans spans;
    for (std::size_t i = 0; (queries & 16) && i < n; ++i) {
        all_spans(program, rays[i], scratch, spans);
        for (const Span& s : spans) {
            record.add(s.in.has_value()), record.add(s.out.has_value());
            if (s.in) record.add(*s.in);
            if (s.out) record.add(*s.out);
        }
    }
    counters += scratch.counters;
    return record.bytes;
}

Use use_of(NodeId node, const Vec3& at = Vec3(0)) { return {node, kNoLabel, 0, Placement::translation(at)}; }

Use ball(SolidBuilder& b, Random& random, double size) {
    const Vec3 centre = random.point({Vec3(-1), Vec3(1)});
    return use_of(b.shape(shape::Ellipsoid{Vec3(random.between(0.5, 1) * size)}), centre);
}

// Balls, as a union or cut out of a box.
Solid many_balls(int count, double size, bool cut) {
    SolidBuilder b;
    Random random(5);
    std::vector<Use> uses;
    if (cut) uses.push_back(use_of(b.shape(shape::Box{Vec3(-1), Vec3(1)})));
    for (int i = 0; i < count; ++i) uses.push_back(ball(b, random, size));
    return b.finish(use_of(b.combine(cut ? SetOp::kDifference : SetOp::kUnion, uses)));
}

// A tree of large overlapping balls, three operations turn by turn.
Use deep(SolidBuilder& b, Random& random, int depth) {
    if (depth == 0) return ball(b, random, 1.2);
    constexpr std::array<SetOp, 3> kOps{SetOp::kUnion, SetOp::kDifference, SetOp::kIntersection};
    const Use left = deep(b, random, depth - 1), right = deep(b, random, depth - 1);
    return use_of(b.combine(kOps[static_cast<std::size_t>(depth) % 3], {left, right}));
}

Solid deep_solid() {
    SolidBuilder b;
    Random random(11);
    return b.finish(deep(b, random, 9));
}

std::vector<Ray> camera(int side, const Vec3& eye) {
    std::vector<Ray> rays;
    for (int i = 0; i < side * side; ++i) {
        const int tile = i / 256, in = i % 256, across = tile % (side / 16) * 16 + in % 16, up = tile / (side / 16) * 16 + in / 16;
        Ray ray;
        ray.origin = eye;
        ray.direction = Vec3(-1.5 + 3.0 * (across + 0.5) / side, -1.5 + 3.0 * (up + 0.5) / side, 0) - ray.origin;
        rays.push_back(ray);
    }
    return rays;
}

std::uint64_t work(const EngineCounters& c) { return c.primitive_tests + c.folded + c.escalated_double_double; }

// Switched off, the pass saves nothing, the work rises and no bit of the answers changes.
void check_pass(EnginePass pass, const Solid& solid, unsigned queries, const Vec3& eye = {3, 2.5, 4}) {
    EngineOptions without;
    without.disabled_passes = {name_of(pass)};
    EngineCounters a, b;
    const std::vector<Ray> rays = camera(64, eye);
    const std::string all = answers(*compiled(solid), rays, HUGE_VAL, queries, a);
    const std::string less = answers(*compiled(solid, without), rays, HUGE_VAL, queries, b);
    INFO(name_of(pass));
    CHECK((all == less));
    CHECK(all.size() > 1000);
    CHECK(a.skipped_by(pass) > 0);
    CHECK(b.skipped_by(pass) == 0);
    // What bounds of a tile let through is left to the packets' masks.
    const auto all_work = [&](EngineCounters& c) { return work(c) + (pass == EnginePass::kFrustum ? c.skipped_by(EnginePass::kMasks) : 0); };
    CHECK(all_work(b) > all_work(a));
}

}  // namespace

TEST_CASE("a group whose box the ray misses is not asked") {
    SolidBuilder b;
    std::vector<Use> pairs;
    for (int i = 0; i < 3; ++i) {
        const NodeId whole = b.shape(shape::Ellipsoid{Vec3(0.3)}), bite = b.shape(shape::Ellipsoid{Vec3(0.25)});
        pairs.push_back(use_of(b.combine(SetOp::kDifference, {use_of(whole), use_of(bite, {0, 0, 0.2})}), {0.8 * (i - 1), 0, 0}));
    }
    check_pass(EnginePass::kBoxes, b.finish(use_of(b.combine(SetOp::kUnion, pairs))), 2);
}

TEST_CASE("parts of a wide group are found through its hierarchy") {
    check_pass(EnginePass::kHierarchy, many_balls(200, 0.1, false), 2);
    check_pass(EnginePass::kHierarchy, many_balls(200, 0.1, true), 2 | 8 | 16);
}

TEST_CASE("parts behind what is met already are not asked") {
    check_pass(EnginePass::kOcclusion, many_balls(400, 0.2, false), 1);
    check_pass(EnginePass::kOcclusion, many_balls(400, 0.2, false), 2);
    check_pass(EnginePass::kOcclusion, many_balls(400, 0.2, false), 4);
}

TEST_CASE("borders behind the first are not looked for") {
    check_pass(EnginePass::kFirst, many_balls(200, 0.2, false), 2);
    check_pass(EnginePass::kFirst, many_balls(200, 0.2, true), 1);
}

TEST_CASE("a shadow ray takes any border and no normal") {
    check_pass(EnginePass::kAny, many_balls(400, 0.2, false), 4);
    check_pass(EnginePass::kAny, many_balls(400, 0.2, false), 8);
}

TEST_CASE("more digits are asked for only where double cannot tell") {
    check_pass(EnginePass::kFilter, many_balls(50, 0.3, true), 31);
}

TEST_CASE("a tile's rays meet only what its bounds can") {
    check_pass(EnginePass::kFrustum, many_balls(200, 0.1, true), 1);
    check_pass(EnginePass::kFrustum, many_balls(200, 0.1, false), 4);
}

TEST_CASE("far parts of a tile wait until the near ones are missed") {
    // A long post full of holes but for its end, seen on that.
    SolidBuilder b;
    Random random(5);
    std::vector<Use> uses{use_of(b.shape(shape::Box{Vec3(-2, -2, -30), Vec3(2, 2, 1)}))};
    for (int i = 0; i < 1500; ++i) uses.push_back(use_of(b.shape(shape::Ellipsoid{Vec3(0.1)}), random.point({Vec3(-2, -2, -30), Vec3(2, 2, -10)})));
    const Solid post = b.finish(use_of(b.combine(SetOp::kDifference, uses)));
    check_pass(EnginePass::kWindows, post, 1, {0, 0, 8});
    // From the side every tile sees both windows, and some see nothing but the post in the first.
    EngineOptions whole;
    whole.disabled_passes = {name_of(EnginePass::kWindows)};
    EngineCounters unused;
    const std::vector<Ray> rays = camera(64, {3, 2.5, 4});
    CHECK((answers(*compiled(post), rays, HUGE_VAL, 1, unused) == answers(*compiled(post, whole), rays, HUGE_VAL, 1, unused)));
}

TEST_CASE("what is met behind a window is met where the window leaves nothing out") {
    // A deep pit begins in front, and so does all else that a tile sees; its floor lies far behind.
    SolidBuilder b;
    std::vector<Use> uses{use_of(b.shape(shape::Box{Vec3(-3, -3, -30), Vec3(3, 3, 1)})), use_of(b.shape(shape::Box{Vec3(-2, -2, -29), Vec3(2, 2, 2)}))};
    for (int i = 0; i < 400; ++i) uses.push_back(use_of(b.shape(shape::Ellipsoid{Vec3(0.02)}), {-2.9 + 0.014 * i, -2.5, 1}));
    const auto program = compiled(b.finish(use_of(b.combine(SetOp::kDifference, uses))));
    std::vector<Ray> rays;
    for (int i = 0; i < 256; ++i) {
        Ray ray;
        ray.origin = {0.001 * (i % 16), 0.001 * (i / 16), 4};
        ray.direction = {0.0001 * (i % 16), 0, -1};
        rays.push_back(ray);
    }
    EngineCounters unused;
    CHECK((answers(*program, rays, HUGE_VAL, 1, unused) == answers(*program, rays, HUGE_VAL, 2, unused)));
    CHECK((answers(*program, rays, HUGE_VAL, 4, unused) == answers(*program, rays, HUGE_VAL, 8, unused)));
}

TEST_CASE("packets of a tile that cannot meet a part are left out") {
    check_pass(EnginePass::kMasks, many_balls(200, 0.1, false), 1);
    check_pass(EnginePass::kMasks, many_balls(200, 0.1, true), 1 | 4);
}

TEST_CASE("deep trees are folded to the cells of an octree") { check_pass(EnginePass::kCells, deep_solid(), 1 | 4); }

TEST_CASE("random solids full of coincidences answer the same without any one pass") {
    const std::uint64_t seed = Catch::rngSeed() == 0 ? 1 : Catch::rngSeed();
    std::size_t hits = 0;
    for (int theme = 0; theme < kThemes; ++theme)
        for (std::uint64_t i = 0; i < 3; ++i) {
            const RandomSolid solid = random_solid(static_cast<Theme>(theme), seed * 1000 + i);
            const auto program = compile(solid.solid);
            if (!program) continue;
            std::mt19937_64 random(i);
            std::vector<Ray> rays;
            for (int k = 0; k < 32; ++k) {
                rays.push_back(random_ray(solid, random));
                rays.back().departure = nullptr;
            }
            EngineCounters unused;
            const std::string all = answers(**program, rays, HUGE_VAL, 31, unused);
            hits += all.size() > 500;
            for (std::size_t p = 0; p < kEnginePasses; ++p) {
                EngineOptions without;
                without.disabled_passes = {name_of(static_cast<EnginePass>(p))};
                INFO(name_of(static_cast<Theme>(theme)) << " " << seed * 1000 + i << " without " << without.disabled_passes[0]);
                CHECK((answers(*compiled(solid.solid, without), rays, HUGE_VAL, 31, unused) == all));
            }
        }
    CHECK(hits > 10);
}

TEST_CASE("every pass of the engine stands in the table that --disable takes") {
    for (std::size_t p = 0; p < kEnginePasses; ++p) {
        bool known = false;
        for (const PassInfo& pass : known_passes()) known = known || pass.name == name_of(static_cast<EnginePass>(p));
        CHECK(known);
    }
}
