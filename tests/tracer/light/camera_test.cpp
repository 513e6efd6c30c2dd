#include <catch2/catch.hpp>

#include <cmath>

#include "tracer/light/camera.h"

using namespace whittle;

namespace {

const Bounds kBox{Vec3(1, 2, 3), Vec3(5, 6, 9)};  // centre (3, 4, 6), half diagonal sqrt(17)
const double kHalfDiagonal = std::sqrt(17.0);
constexpr double kPi = 3.14159265358979323846;

Lens lens_of(const CameraSpec& spec, const ViewVariables& view = {}, const std::optional<Camera>& camera = {}, double aspect = 1) {
    const Result<Lens> lens = resolve_camera(spec, camera, view, kBox, aspect);
    REQUIRE(lens);
    return *lens;
}

void check_near(Vec3 a, Vec3 b, double margin = 1e-12) {
    for (int i = 0; i < 3; ++i) CHECK(a[i] == Approx(b[i]).margin(margin));
}

double framing_distance(double half_angle_deg = 11.25) { return kHalfDiagonal / std::sin(half_angle_deg * kPi / 180); }

}  // namespace

TEST_CASE("without any wish the box is framed whole from OpenSCAD's angle") {
    const Lens lens = lens_of({});
    const Vec3 away = lens.eye - Vec3(3, 4, 6);
    CHECK(glm::length(away) == Approx(framing_distance()));
    const double a = 55 * kPi / 180, b = 25 * kPi / 180;
    check_near(glm::normalize(away), Vec3(std::sin(a) * std::sin(b), -std::sin(a) * std::cos(b), std::cos(a)));
    CHECK(lens.half_height == Approx(std::tan(11.25 * kPi / 180)));
}

TEST_CASE("the gimbal's seven numbers are target, rotation and distance") {
    CameraSpec spec;
    spec.numbers = {1, 2, 3, 90, 0, 90, 10};
    const Lens lens = lens_of(spec);
    check_near(lens.eye, Vec3(11, 2, 3));
    check_near(lens.forward, Vec3(-1, 0, 0));
    check_near(lens.up, Vec3(0, 0, 1));
    spec.numbers = {0, 0, 0, 0, 0, 0, 7};
    check_near(lens_of(spec).eye, Vec3(0, 0, 7));
    check_near(lens_of(spec).up, Vec3(0, 1, 0));
}

TEST_CASE("six numbers are eye and centre with z up, and y up along z") {
    CameraSpec spec;
    spec.numbers = {0, -10, 0, 0, 0, 0};
    check_near(lens_of(spec).up, Vec3(0, 0, 1));
    check_near(lens_of(spec).right, Vec3(1, 0, 0));
    spec.numbers = {0, 0, 10, 0, 0, 0};
    check_near(lens_of(spec).up, Vec3(0, 1, 0));
    spec.numbers = {0, 0, -10, 0, 0, 0};
    check_near(lens_of(spec).up, Vec3(0, -1, 0));
}

TEST_CASE("any other count of numbers is refused in OpenSCAD's words") {
    CameraSpec spec;
    spec.numbers = {1, 2, 3};
    const Result<Lens> lens = resolve_camera(spec, {}, {}, kBox, 1);
    REQUIRE(!lens);
    CHECK(lens.error().fault == Fault::kCommand);
    CHECK(lens.error().message == "Camera setup requires either 7 numbers for Gimbal Camera or 6 numbers for Vector Camera");
    spec.numbers = {1, 2, 3, 1, 2, 3};
    CHECK(!resolve_camera(spec, {}, {}, kBox, 1));
}

TEST_CASE("viewall frames the box from the given target, autocenter moves the target") {
    CameraSpec spec;
    spec.numbers = {0, 0, 0, 0, 0, 0, 1};
    spec.viewall = true;
    const double off = glm::length(Vec3(3, 4, 6));
    check_near(lens_of(spec).eye, Vec3(0, 0, (off + kHalfDiagonal) / std::sin(11.25 * kPi / 180)), 1e-9);
    spec.autocenter = true;
    check_near(lens_of(spec).eye, Vec3(3, 4, 6 + framing_distance()), 1e-9);
}

TEST_CASE("a tall picture is framed to its width") {
    const double half = std::atan(std::tan(11.25 * kPi / 180) / 2) * 180 / kPi;
    CHECK(lens_of({}, {}, {}, 0.5).target_distance == Approx(framing_distance(half)));
    CHECK(lens_of({}, {}, {}, 2).target_distance == Approx(framing_distance()));
}

TEST_CASE("the command line's camera beats the scene's, that beats the view variables") {
    ViewVariables view;
    view.rotation_deg = Vec3(0);
    view.target = Vec3(0);
    view.distance = 50;
    check_near(lens_of({}, view).eye, Vec3(0, 0, 50));
    Camera camera;
    camera.eye = Vec3(0, -20, 0);
    camera.exposure = 1.5;
    camera.aperture = 2;
    check_near(lens_of({}, view, camera).eye, Vec3(0, -20, 0));
    CHECK(lens_of({}, view, camera).exposure == 1.5);
    CHECK(lens_of({}, view, camera).focus == Approx(20));
    CameraSpec spec;
    spec.numbers = {0, 0, 0, 0, 0, 0, 9};
    check_near(lens_of(spec, view, camera).eye, Vec3(0, 0, 9));
    CHECK(lens_of(spec, view, camera).aperture == 0);
}

TEST_CASE("orthographic rays are parallel and the half height is distance times tangent") {
    CameraSpec spec;
    spec.numbers = {0, 0, 0, 0, 0, 0, 10};
    spec.orthographic = true;
    const Lens lens = lens_of(spec);
    CHECK(lens.half_height == Approx(10 * std::tan(11.25 * kPi / 180)));
    const Ray top = camera_ray(lens, 0, 1), middle = camera_ray(lens, 0, 0);
    check_near(top.direction, middle.direction);
    check_near(top.origin - middle.origin, Vec3(0, lens.half_height, 0));
}

TEST_CASE("the border of the picture lies half the field of view off the middle") {
    CameraSpec spec;
    spec.numbers = {0, 0, 0, 0, 0, 0, 10};
    const Lens lens = lens_of(spec);
    const double cosine = glm::dot(camera_ray(lens, 0, 1).direction, camera_ray(lens, 0, 0).direction);
    CHECK(std::acos(cosine) * 180 / kPi == Approx(11.25));
}

TEST_CASE("rays through every place of the lens meet in the plane of focus, and spread by the lens equation elsewhere") {
    CameraSpec spec;
    Camera camera;
    camera.eye = Vec3(0, 0, 100);
    camera.aperture = 8;
    camera.focus = 60;
    const Lens lens = lens_of(spec, {}, camera);
    double widest = 0;
    for (int i = 0; i < 64; ++i) {
        const Vec2 u((i % 8 + 0.5) / 8, (i / 8 + 0.5) / 8);
        const Ray sharp = camera_ray(lens, 0.3, -0.4), ray = camera_ray(lens, 0.3, -0.4, u);
        const auto at_depth = [&](const Ray& r, double depth) { return r.origin + r.direction * (depth / glm::dot(r.direction, lens.forward)); };
        check_near(at_depth(ray, 60), at_depth(sharp, 60), 1e-9);
        widest = std::max(widest, glm::length(at_depth(ray, 90) - at_depth(sharp, 90)));
        CHECK(glm::length(ray.direction) == Approx(1));
    }
    // Similar triangles: radius x |90 - 60| / 60, the outermost place drawn has radius sqrt(7.5/8).
    CHECK(widest == Approx(4 * std::sqrt(7.5 / 8) * 30 / 60));
}

TEST_CASE("a box without extent or without end still gives a camera") {
    CHECK(resolve_camera({}, {}, {}, Bounds{}, 1));
    const Result<Lens> lens = resolve_camera({}, {}, {}, Bounds{Vec3(-INFINITY), Vec3(INFINITY)}, 1);
    REQUIRE(lens);
    CHECK(std::isfinite(lens->eye.x));
    Camera camera;
    camera.eye = camera.target = Vec3(1);
    CHECK(!resolve_camera({}, camera, {}, kBox, 1));
}
