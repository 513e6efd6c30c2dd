// Light from pictures of the surroundings, and apertures.
#include "scenes.h"

#include <cmath>
#include <limits>

#include "tracer/light/camera.h"
#include "tracer/light/environment.h"
#include "tracer/light/lights.h"
#include "tracer/light/sampler.h"
#include "tracer/light/scattering.h"

using namespace whittle;
using namespace whittle::test;

namespace {

Image picture(int width, int height) {
    Image image;
    image.width = width;
    image.height = height;
    image.channels = {"R", "G", "B"};
    image.types.assign(3, ChannelType::kFloat);
    image.floats.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3, 0.0f);
    return image;
}

void set(Image& image, int x, int y, Vec3 light) {
    for (int c = 0; c < 3; ++c) image.floats[static_cast<std::size_t>((y * image.width + x) * 3 + c)] = static_cast<float>(light[c]);
}

// Brightest at +x, dim elsewhere.
Image lopsided() {
    Image image = picture(32, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) set(image, x, y, Vec3(0.1 + 0.01 * y, 0.2, x > 20 && x < 27 && y > 4 && y < 9 ? 30 : 0.05));
    return image;
}

EnvironmentMap map_of(const Image& image, Vec3 rotate_deg = Vec3(0)) {
    std::size_t mended = 0;
    return EnvironmentMap(image, Vec3(1), rotate_deg, mended);
}

Light environment_of_file(const char* name) {
    EnvironmentLight e;
    e.file = name;
    return {e, {}};
}

}  // namespace

TEST_CASE("the middle of a picture of surroundings lies at +y, its right quarter at +x, its top at +z") {
    Image image = picture(64, 32);
    set(image, 32, 16, Vec3(1, 0, 0));
    set(image, 48, 16, Vec3(0, 1, 0));
    for (int x = 0; x < 64; ++x) set(image, x, 0, Vec3(0, 0, 1));
    const EnvironmentMap map = map_of(image);
    CHECK(map.radiance(glm::normalize(Vec3(0.049, 1, -0.049))).x == Approx(1).epsilon(0.02));
    CHECK(map.radiance(glm::normalize(Vec3(1, -0.049, -0.049))).y == Approx(1).epsilon(0.02));
    CHECK(map.radiance(Vec3(0, 0, 1)).z == Approx(1));
    // Turned by 90 degrees about z: what was at +y is at -x.
    CHECK(map_of(image, Vec3(0, 0, 90)).radiance(glm::normalize(Vec3(-1, 0.049, -0.049))).x == Approx(1).epsilon(0.02));
}

TEST_CASE("directions are drawn with the density that is claimed, and it sums to one") {
    const EnvironmentMap map = map_of(lopsided());
    double sum = 0;
    const std::uint32_t n = 1U << 17;
    for (std::uint32_t i = 0; i < n; ++i) sum += map.density(on_cap(Sampler(1, 1, 1, i).pair(Draw::kSky), 2)) * 4 * kPi / n;
    CHECK(sum == Approx(1).epsilon(5e-3));
    for (std::uint32_t i = 0; i < 500; ++i) {
        const EnvironmentMap::Drawn d = map.draw(Sampler(2, 1, 1, i).pair(Draw::kSky));
        CHECK(glm::length(d.direction) == Approx(1));
        CHECK(d.density == Approx(map.density(d.direction)));
        CHECK(d.density > 0);
    }
}

TEST_CASE("irradiance under a picture is the same by its own draws, by even ones, and nearly by harmonics") {
    const EnvironmentMap map = map_of(lopsided());
    const Vec3 normal = glm::normalize(Vec3(0.9, 0.1, 0.5));
    Vec3 drawn_sum(0), even(0);
    const std::uint32_t n = 1U << 16;
    for (std::uint32_t i = 0; i < n; ++i) {
        const Vec2 u = Sampler(3, 1, 1, i).pair(Draw::kSky);
        const EnvironmentMap::Drawn d = map.draw(u);
        drawn_sum += map.radiance(d.direction) * (std::max(0.0, glm::dot(d.direction, normal)) / d.density / n);
        even += map.radiance(ShadingFrame(normal).to_world(on_cosine_hemisphere(u))) * (kPi / n);
    }
    for (int c = 0; c < 3; ++c) {
        CHECK(drawn_sum[c] == Approx(even[c]).epsilon(5e-3));
        CHECK(map.smooth(normal)[c] * kPi == Approx(even[c]).epsilon(0.15));
    }
}

TEST_CASE("under a picture, paths and shadow rays to its bright places make the same picture") {
    SceneBuilder b;
    Material plastic = preset("plastic");
    b.add(b.ball(5, plastic));
    const Solid solid = b.finish();
    RenderScene scene;
    scene.camera = looking(Vec3(0, -30, 5));
    scene.lights = {environment_of_file("sky.hdr")};
    scene.read_picture = [](const std::string&, const SourcePlace&) -> Result<Image> { return lopsided(); };
    RenderOptions o = small_options();
    o.width = o.height = 8;
    o.samples = 512;
    o.max_depth = 1;
    const auto mean = [&](Integrator kind) {
        o.integrator = kind;
        const Film film = drawn(solid, scene, o).film;
        Vec3 sum(0);
        for (std::size_t i = 0; i < film.pixels.size(); ++i) sum += film.color(i) / static_cast<double>(film.pixels.size());
        return sum;
    };
    const Vec3 path = mean(Integrator::kPath), distributed = mean(Integrator::kDistributed);
    for (int c = 0; c < 3; ++c) CHECK(path[c] == Approx(distributed[c]).epsilon(0.02));
}

TEST_CASE("what is no number in a picture of surroundings is no light, and it is said") {
    Image image = lopsided();
    set(image, 3, 3, Vec3(std::numeric_limits<double>::quiet_NaN(), 1, 1));
    set(image, 4, 3, Vec3(-5, 1, 1));
    set(image, 5, 3, Vec3(std::numeric_limits<double>::infinity(), 1, 1));
    RenderScene scene;
    scene.camera = looking(Vec3(0, -30, 5));
    scene.lights = {environment_of_file("sky.hdr")};
    scene.read_picture = [&](const std::string&, const SourcePlace&) -> Result<Image> { return image; };
    for (Integrator kind : {Integrator::kWhitted, Integrator::kDistributed, Integrator::kPath}) {
        RenderOptions o = small_options();
        o.integrator = kind;
        const RenderResult r = drawn(classic(), scene, o);
        CHECK(all_finite(r.film));
        REQUIRE(r.warnings.size() == 1);
        CHECK(r.warnings[0].find("3 pixels") != std::string::npos);
    }
}

TEST_CASE("a picture that cannot be read is an error") {
    RenderScene scene;
    scene.lights = {environment_of_file("none.hdr")};
    const auto program = compile(classic());
    REQUIRE(program);
    RenderControl control;
    const Result<RenderResult> result = render(*program, scene, small_options(), control);
    REQUIRE(!result);
    CHECK(result.error().message.find("none.hdr") != std::string::npos);
}

TEST_CASE("a rectangle is sampled evenly over its solid angle, a distant one too") {
    AreaLight area;
    area.u = Vec3(4, 0, 0);
    area.v = Vec3(0, 3, 0);
    area.power = 10;
    for (double height : {0.05, 2.0, 50.0, 1e6}) {
        area.p = Vec3(-1, -1, height);
        const LightSource light = resolve_light(area, Vec3(0));
        double least = 1e300, most = 0;
        for (std::uint32_t i = 0; i < 256; ++i) {
            const LightSample s = sample_light(light, Vec3(0), Sampler(1, 1, 1, i).pair(Draw::kLight));
            least = std::min(least, s.density);
            most = std::max(most, s.density);
            const Vec3 at = s.distance * s.direction;
            CHECK(at.z == Approx(height));
            CHECK(at.x >= -1 - 1e-9);
            CHECK(at.x <= 3 + 1e-9);
            CHECK(at.y <= 2 + 1e-9);
            LightMet met;
            REQUIRE(meet_lights({light}, Vec3(0), s.direction, 1e300, met));
            CHECK(met.density == Approx(s.density).epsilon(1e-6));
        }
        CHECK(most / least == Approx(1).epsilon(1e-4));
        // A square of side s at the distance h in the limit: s^2 / h^2.
        if (height > 1e5) CHECK(1 / most == Approx(12 / (height * height)).epsilon(1e-6));
    }
}

TEST_CASE("rays of a thin lens meet in the plane of focus; elsewhere they fill the circle of confusion, or its polygon") {
    Lens lens;
    lens.aperture = 4;
    lens.focus = 100;
    for (int blades : {0, 3, 6}) {
        lens.blades = blades;
        double widest = 0, area = 0;
        const std::uint32_t n = 4096;
        const double apothem = blades > 0 ? std::cos(kPi / blades) : 1;
        for (std::uint32_t i = 0; i < n; ++i) {
            const Ray ray = camera_ray(lens, 0.3, -0.2, Sampler(5, 1, 1, i).pair(Draw::kLens));
            const Vec3 sharp = point_at(ray, lens.focus / -ray.direction.z), behind = point_at(ray, 150 / -ray.direction.z);
            CHECK(glm::length(sharp - Vec3(0.3 * 0.2 * 100, -0.2 * 0.2 * 100, -100)) < 1e-10);
            const Vec2 spot = Vec2(behind) - Vec2(0.3 * 0.2, -0.2 * 0.2) * 150.0;
            widest = std::max(widest, glm::length(spot));
            area += glm::length(spot) < apothem * 0.5 ? 1.0 / n : 0;
        }
        // Aperture x |d - f| / f is the diameter.
        INFO(blades << " blades");
        CHECK(widest <= 1 + 1e-12);
        CHECK(widest > 0.97);
        // The circle of half the inscribed one's radius holds its share of the area.
        const double whole = blades > 0 ? 0.5 * blades * std::sin(2 * kPi / blades) : kPi;
        CHECK(area == Approx(kPi * 0.25 * apothem * apothem / whole).epsilon(0.02));
    }
}

TEST_CASE("a place seen through the lens is where the camera's ray to it starts") {
    Lens lens;
    lens.aperture = 4;
    lens.focus = 80;
    for (bool orthographic : {false, true})
        for (std::uint32_t i = 0; i < 50; ++i) {
            lens.orthographic = orthographic;
            lens.half_height = orthographic ? 15 : 0.2;
            const Vec2 u = Sampler(7, 1, 1, i).pair(Draw::kLens);
            const Vec3 point(3 - 0.2 * i, 2, -50 - 2.0 * i);
            const std::optional<Sighting> seen = sighting(lens, point, u);
            REQUIRE(seen);
            const Ray ray = camera_ray(lens, seen->x, seen->y, u);
            CHECK(glm::length(glm::cross(point - ray.origin, ray.direction)) < 1e-9);
            CHECK(glm::length(ray.origin - seen->eye) < 1e-9);
        }
    CHECK(!sighting(lens, Vec3(0, 0, 5), Vec2(0.5)));
}
