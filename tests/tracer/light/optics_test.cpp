// Lenses, prisms and mirrors made by set operations, against closed forms: rays followed border by border.
#include "scenes.h"

#include <cmath>

#include "tracer/light/clear.h"
#include "tracer/light/sampler.h"
#include "tracer/light/scattering.h"
#include "tracer/light/world.h"

using namespace whittle;
using namespace whittle::test;

namespace {

Material glass_of(double index) {
    Material m = preset("glass");
    m.ior = index;
    return m;
}

// The light of one ray, refracted wherever it can be.
class Bench {
public:
    explicit Bench(SceneBuilder& b) : solid_(b.finish()) {
        const auto program = compile(solid_);
        REQUIRE(program);
        Result<World> world = World::make(*program, &solid_);
        REQUIRE(world);
        world_ = std::make_unique<World>(std::move(*world));
    }

    // After at most `most` borders; `bent` counts refractions, `turned` total reflections and mirrors.
    Ray through(Vec3 origin, Vec3 direction, int most = 100) {
        Ray ray;
        ray.origin = origin;
        ray.direction = glm::normalize(direction);
        Leaving leaving;
        bent = turned = 0;
        for (int i = 0; i < most; ++i) {
            Border border;
            if (!world_->next(ray, i > 0 ? &leaving : nullptr, 1e12, scratch_, border)) return ray;
            ray.origin = border.point;
            leaving = border.leaving;
            std::optional<Vec3> onward;
            if (border.surface->transmission > 0) onward = refracted(ray.direction, border.normal, border.eta());
            ++(onward ? bent : turned);
            ray.direction = onward.value_or(mirrored(ray.direction, border.normal));
        }
        return ray;
    }

    int bent = 0, turned = 0;

private:
    Solid solid_;
    std::unique_ptr<World> world_;
    Scratch scratch_;
};

// Where a ray crosses the axis x = 0 (in the plane y = 0).
double crosses_axis(const Ray& ray) { return ray.origin.z - ray.origin.x * ray.direction.z / ray.direction.x; }

}  // namespace

TEST_CASE("a ball lens focuses n r / 2 (n - 1) behind its middle") {
    for (double index : {1.333, 1.5, 1.8}) {
        SceneBuilder b;
        b.add(b.ball(10, glass_of(index)));
        Bench bench(b);
        const double height = 1e-3;
        CHECK(-crosses_axis(bench.through(Vec3(height, 0, 50), Vec3(0, 0, -1))) == Approx(index * 10 / (2 * (index - 1))).epsilon(1e-7));
        CHECK(bench.bent == 2);
    }
}

TEST_CASE("a biconvex lens made of two balls focuses where the lensmaker's equation says") {
    // Radii 60 and 40; the lens reaches from z = -2 to z = 3.
    const double r1 = 60, r2 = 40, thick = 5, index = 1.52;
    SceneBuilder b;
    b.add(b.combined(SetOp::kIntersection, {b.ball(r1, glass_of(index), moved(0, 0, 3 - r1)), b.ball(r2, glass_of(index), moved(0, 0, r2 - 2))}));
    Bench bench(b);
    const double power = (index - 1) * (1 / r1 + 1 / r2 - (index - 1) * thick / (index * r1 * r2)), focal = 1 / power;
    // Light comes down on the face of r1; the back focal distance is counted from the other vertex.
    const double back = focal * (1 - (index - 1) * thick / (index * r1));
    const Ray out = bench.through(Vec3(1e-3, 0, 50), Vec3(0, 0, -1));
    CHECK(-2 - crosses_axis(out) == Approx(back).epsilon(1e-7));
    CHECK(-out.direction.z / -out.direction.x * 1e-3 == Approx(focal).epsilon(1e-7));
}

TEST_CASE("a cemented doublet, touching or overlapping, bends as the two lenses' matrices say") {
    // Crown (n1) before flint (n2): spheres of radius 50, -50, -200, vertices at z = 4, 0, -2.
    const double n1 = 1.5, n2 = 1.62;
    const auto focus = [&](bool overlapping) {
        SceneBuilder b;
        Material crown = glass_of(n1), flint = glass_of(n2);
        crown.priority = 1;
        const Use front = b.ball(50, crown, moved(0, 0, 4 - 50)), middle = b.ball(50, crown, moved(0, 0, 50));
        b.add(b.combined(SetOp::kIntersection, {front, middle}));
        const Use reach = b.combined(SetOp::kIntersection, {b.box(Vec3(-8, -8, -30), Vec3(8, 8, overlapping ? 2.0 : 20.0), flint), b.ball(200, flint, moved(0, 0, 198))});
        if (overlapping) b.add(reach);
        else b.add(b.combined(SetOp::kDifference, {reach, b.ball(50, flint, moved(0, 0, 50)), b.box(Vec3(-9, -9, 2), Vec3(9, 9, 30), flint)}));
        Bench bench(b);
        const double z = crosses_axis(bench.through(Vec3(1e-3, 0, 60), Vec3(0, 0, -1)));
        CHECK(bench.bent == 3);
        return -2 - z;
    };
    // Paraxial: height y and n * angle u through three faces.
    double y = 1, u = 0;
    u -= y * (n1 - 1) / 50;
    y += 4 * u / n1;
    u -= y * (n2 - n1) / -50;
    y += 2 * u / n2;
    u -= y * (1 - n2) / -200;
    CHECK(focus(true) == Approx(-y / u).epsilon(1e-6));
    CHECK(focus(false) == Approx(-y / u).epsilon(1e-6));
}

TEST_CASE("the least deviation of a prism cut by half-spaces is that of the formula") {
    const double apex = kPi / 3, s = std::sin(apex / 2), c = std::cos(apex / 2), index = 1.5;
    SceneBuilder b;
    SolidBuilder& shapes = b.shapes();
    b.add(b.combined(SetOp::kIntersection, {b.use(shapes.shape(shape::HalfSpace{Vec3(-c, 0, s), 0}), glass_of(index)),
                                            b.use(shapes.shape(shape::HalfSpace{Vec3(c, 0, s), 0}), glass_of(index)), b.box(Vec3(-100, -50, -60), Vec3(100, 50, 10), glass_of(index))}));
    Bench bench(b);
    double least = 10;
    for (int i = 0; i <= 2000; ++i) {
        const double angle = (40 + 20.0 * i / 2000) * kPi / 180;
        const Vec3 in = -std::cos(angle) * Vec3(-c, 0, s) + std::sin(angle) * Vec3(s, 0, c);
        const Ray out = bench.through(Vec3(-20 * s / c, 0, -20) - 50.0 * in, in);
        if (bench.bent == 2 && bench.turned == 0) least = std::min(least, std::acos(glm::dot(in, out.direction)));
    }
    CHECK(least == Approx(2 * std::asin(index * s) - apex).epsilon(1e-7));
}

TEST_CASE("the critical angle of a block is met to 1e-6 degrees") {
    SceneBuilder b;
    b.add(b.box(Vec3(-1000, -1000, -10), Vec3(1000, 1000, 0), glass_of(1.5)));
    Bench bench(b);
    const double critical = std::asin(1 / 1.5) * 180 / kPi;
    for (double off : {-1e-6, 1e-6}) {
        const double angle = (critical + off) * kPi / 180;
        bench.through(Vec3(0, 0, -5), Vec3(std::sin(angle), 0, std::cos(angle)), 1);
        CHECK(bench.bent == (off < 0 ? 1 : 0));
        CHECK(bench.turned == (off < 0 ? 0 : 1));
    }
}

TEST_CASE("a corner cut out of a mirror block sends rays back") {
    SceneBuilder b;
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-20), Vec3(0), preset("mirror")), b.box(Vec3(-10), Vec3(10), preset("mirror"))}));
    Bench bench(b);
    for (double x : {-1.0, -4.0, -7.0})
        for (double y : {-2.0, -5.5}) {
            const Vec3 in = glm::normalize(Vec3(-0.5 + 0.01 * x, -0.6, -0.7 + 0.02 * y));
            const Ray out = bench.through(Vec3(x, y, -3) - 40.0 * in, in);
            if (bench.turned != 3) continue;
            CHECK(glm::length(out.direction + in) < 1e-15);
        }
    const Vec3 in = glm::normalize(Vec3(-0.5, -0.6, -0.7));
    bench.through(Vec3(-4, -4, -4) - 40.0 * in, in);
    CHECK(bench.turned == 3);
}

TEST_CASE("between two facing mirrors the k-th image stands k times as far") {
    // Mirrors at x = 0 and x = 10; after k reflections a ray has gone straight on in the unfolded room.
    SceneBuilder b;
    b.add(b.box(Vec3(-1, -50, -200), Vec3(0, 50, 200), preset("mirror")));
    b.add(b.box(Vec3(10, -50, -200), Vec3(11, 50, 200), preset("mirror")));
    Bench bench(b);
    const Vec3 in = glm::normalize(Vec3(1, 0, 0.3));
    for (int k : {1, 2, 5, 20}) {
        const Ray out = bench.through(Vec3(4, 0, 0), in, k);
        CHECK(out.origin.z == Approx((10.0 * k - 4) * 0.3).epsilon(1e-12));
    }
}

TEST_CASE("liquid in a glass: a ray follows Snell's law from glass to liquid, where they touch and where they overlap") {
    for (double reach : {0.0, 0.5}) {
        SceneBuilder b;
        Material glass = glass_of(1.5), water = glass_of(1.333);
        glass.priority = 1;
        b.add(b.box(Vec3(-50, -50, 0), Vec3(50, 50, 2), glass));
        b.add(b.box(Vec3(-50, -50, -10), Vec3(50, 50, reach), water));
        Bench bench(b);
        const double angle = 40 * kPi / 180;
        const Ray within = bench.through(Vec3(0, 0, 10), Vec3(std::sin(angle), 0, -std::cos(angle)), 2);
        CHECK(bench.bent == 2);
        CHECK(within.origin.z == Approx(0).margin(1e-12));
        CHECK(within.direction.x == Approx(std::sin(angle) / 1.333).epsilon(1e-14));
        CHECK(within.origin.x == Approx(10 * std::tan(angle) - 2 * std::tan(angle) + 2 * std::tan(std::asin(std::sin(angle) / 1.5))).epsilon(1e-12));
    }
}

TEST_CASE("a bubble in glass spreads light: its focus is the ball lens's, turned inside out") {
    SceneBuilder b;
    b.add(b.combined(SetOp::kDifference, {b.box(Vec3(-30), Vec3(30), glass_of(1.5)), b.ball(10)}));
    Bench bench(b);
    const Ray out = bench.through(Vec3(1e-3, 0, 29), Vec3(0, 0, -1), 2);
    CHECK(bench.bent == 2);
    // Relative index 1/1.5: f = m r / 2 (m - 1), in front of the ball.
    const double m = 1 / 1.5;
    CHECK(crosses_axis(out) == Approx(-m * 10 / (2 * (m - 1))).epsilon(1e-6));
}

TEST_CASE("a squeezed, mirrored, sheared instance has the borders of the same solid written out, normals to 1e-12") {
    // x' = 2x + 0.5 z, y' = -0.5 y, z' = 3z, of a box by its corners.
    const Placement placed{{2, 0, 0.5, 1, 0, -0.5, 0, 2, 0, 0, 3, -3}};
    const std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0}, {4, 5, 0}, {0, 5, 0}, {0, 0, 6}, {4, 0, 6}, {4, 5, 6}, {0, 5, 6}};
    SceneBuilder instanced;
    Use box = instanced.box(Vec3(0), Vec3(4, 5, 6));
    box.placement = placed;
    instanced.add(box);
    // The faces of the same box, each as a half-space through the image of its corners.
    SceneBuilder written;
    std::vector<Use> sides;
    const auto image = [&](int i) {
        const Vec3 p = corners[static_cast<std::size_t>(i)];
        return Vec3(2 * p.x + 0.5 * p.z + 1, -0.5 * p.y + 2, 3 * p.z - 3);
    };
    const Vec3 middle = (image(0) + image(6)) * 0.5;
    for (const auto& face : {std::array{0, 1, 2}, {4, 5, 6}, {0, 1, 5}, {3, 2, 6}, {0, 3, 7}, {1, 2, 6}}) {
        Vec3 n = glm::cross(image(face[1]) - image(face[0]), image(face[2]) - image(face[0]));
        if (glm::dot(n, middle - image(face[0])) > 0) n = -n;
        sides.push_back(written.use(written.shapes().shape(shape::HalfSpace{n, glm::dot(n, image(face[0]))})));
    }
    sides.push_back(written.box(Vec3(-100), Vec3(100)));
    written.add(written.combined(SetOp::kIntersection, sides));
    const auto a = compile(instanced.finish()), b = compile(written.finish());
    REQUIRE(a);
    REQUIRE(b);
    Scratch scratch;
    int met = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec2 u = Sampler(11, 1, 1, static_cast<std::uint32_t>(i)).pair(Draw::kPixel), v = Sampler(12, 1, 1, static_cast<std::uint32_t>(i)).pair(Draw::kPixel);
        Ray ray;
        ray.origin = middle + 40.0 * on_cap(u, 2);
        ray.direction = glm::normalize(middle + 5.0 * on_cap(v, 2) - ray.origin);
        Hit first, second;
        const bool found = first_hit(**a, ray, HUGE_VAL, scratch, first);
        CHECK(found == first_hit(**b, ray, HUGE_VAL, scratch, second));
        if (!found) continue;
        ++met;
        CHECK(glm::length(first.end.normal - second.end.normal) < 1e-12);
        CHECK(first.end.t == Approx(second.end.t).epsilon(1e-12));
    }
    CHECK(met > 100);
}

TEST_CASE("the terminator of a ball lies where the light grazes it, at every scale") {
    for (double scale : {1e-6, 1.0, 1e6}) {
        SceneBuilder b;
        b.add(b.ball(10 * scale, matte(1, 1, 1)));
        const auto program = compile(b.finish());
        REQUIRE(program);
        Scratch scratch;
        const Vec3 to_light = glm::normalize(Vec3(1, 2, 3));
        for (int i = 0; i < 500; ++i) {
            const Vec3 place = on_cap(Sampler(13, 1, 1, static_cast<std::uint32_t>(i)).pair(Draw::kPixel), 2);
            Ray ray;
            ray.origin = 30 * scale * place;
            ray.direction = -place;
            Hit hit;
            REQUIRE(first_hit(*program.value(), ray, HUGE_VAL, scratch, hit));
            Ray shadow;
            shadow.origin = hit.point;
            shadow.direction = to_light;
            shadow.departure = &hit.departure;
            // What faces the light sees it: no place shadows itself.
            const double cosine = glm::dot(hit.end.normal, to_light);
            if (std::abs(cosine) < 1e-12) continue;
            CHECK(any_hit(*program.value(), shadow, HUGE_VAL, scratch) == (cosine < 0));
        }
    }
}
