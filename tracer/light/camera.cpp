#include "tracer/light/camera.h"

#include <cmath>

#include <fmt/format.h>

#include "csg/base/degrees.h"
#include "tracer/light/circle.h"

namespace whittle {

namespace {

// OpenSCAD's view when the author says nothing.
constexpr Vec3 kDefaultRotation{55, 0, 25};
constexpr double kDefaultFov = 22.5;
constexpr double kDefaultDistance = 140;

struct Box {
    Vec3 centre{0};
    double half_diagonal = 1;
};

Box framed_box(const Bounds& bounds) {
    const Vec3 diagonal = bounds.hi - bounds.lo;
    const double length = std::sqrt(glm::dot(diagonal, diagonal));
    if (bounds.empty() || !std::isfinite(length)) return {};
    return {bounds.lo + diagonal * 0.5, length > 0 ? length / 2 : 1};
}

double tan_half(double angle_deg) { return sind(angle_deg / 2) / cosd(angle_deg / 2); }

// Half the angle of view to the narrower side, as sine.
double narrow_half_sine(double fov_deg, double aspect) {
    if (aspect >= 1) return sind(fov_deg / 2);
    const double tangent = tan_half(fov_deg) * aspect;
    return tangent / std::sqrt(1 + tangent * tangent);
}

// R = Rz Ry Rx applied to v.
Vec3 turned(Vec3 rotation_deg, Vec3 v) {
    const Vec3 c{cosd(rotation_deg.x), cosd(rotation_deg.y), cosd(rotation_deg.z)}, s{sind(rotation_deg.x), sind(rotation_deg.y), sind(rotation_deg.z)};
    v = {v.x, c.x * v.y - s.x * v.z, s.x * v.y + c.x * v.z};
    v = {c.y * v.x + s.y * v.z, v.y, c.y * v.z - s.y * v.x};
    return {c.z * v.x - s.z * v.y, s.z * v.x + c.z * v.y, v.z};
}

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// What every form of camera comes down to. No distance: frame the box.
struct View {
    Vec3 target{0};
    Vec3 back{0, 0, 1}, up{0, 1, 0};  // unit; back points from the target to the eye
    std::optional<double> distance;
    double fov_deg = kDefaultFov;
    bool orthographic = false;
};

View gimbal_view(Vec3 target, Vec3 rotation_deg, std::optional<double> distance, double fov_deg) {
    return {target, turned(rotation_deg, {0, 0, 1}), turned(rotation_deg, {0, 1, 0}), distance, fov_deg, false};
}

// Eye and centre; `up` is made orthogonal. OpenSCAD looks along z with +y up (from below: -y).
Result<View> vector_view(Vec3 eye, Vec3 centre, Vec3 up, double fov_deg) {
    const Vec3 away = eye - centre;
    const double distance = std::sqrt(glm::dot(away, away));
    if (!finite(eye) || !finite(centre) || !finite(up) || !(distance > 0)) return fail(Fault::kScene, "The camera's eye and target are the same place or not numbers");
    View view;
    view.target = centre;
    view.back = away / distance;
    view.distance = distance;
    view.fov_deg = fov_deg;
    Vec3 flat = up - glm::dot(up, view.back) * view.back;
    // Looking along `up`: the residue is rounding, not a direction.
    constexpr double kParallel = 1e-12;
    if (glm::dot(flat, flat) <= kParallel * glm::dot(up, up)) {
        const Vec3 other{0, view.back.z >= 0 ? 1.0 : -1.0, 0};
        flat = other - glm::dot(other, view.back) * view.back;
        if (glm::dot(flat, flat) <= kParallel) flat = Vec3(0, 0, 1);
    }
    view.up = glm::normalize(flat);
    return view;
}

Result<View> named_view(const std::vector<double>& n, double fov_deg) {
    for (double x : n)
        if (!std::isfinite(x)) return fail(Fault::kCommand, "Camera setup requires finite numbers");
    if (n.size() == 7) return gimbal_view({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6], fov_deg);
    if (n.size() == 6) {
        Result<View> view = vector_view({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {0, 0, 1}, fov_deg);
        if (!view) view.error().fault = Fault::kCommand;
        return view;
    }
    return fail(Fault::kCommand, "Camera setup requires either 7 numbers for Gimbal Camera or 6 numbers for Vector Camera");
}

View view_of_variables(const ViewVariables& v, const Box& box) {
    const bool placed = v.target || v.distance;
    const Vec3 target = v.target.value_or(placed ? Vec3(0) : box.centre);
    std::optional<double> distance = v.distance;
    if (!distance && placed && !v.target) distance = kDefaultDistance;
    return gimbal_view(target, v.rotation_deg.value_or(kDefaultRotation), distance, v.fov_deg.value_or(kDefaultFov));
}

Lens lens_of(const View& view, const Box& box, double aspect) {
    double distance = view.distance.value_or(0);
    if (!view.distance) {
        const Vec3 off = box.centre - view.target;
        distance = (std::sqrt(glm::dot(off, off)) + box.half_diagonal) / narrow_half_sine(view.fov_deg, aspect);
    }
    Lens lens;
    lens.eye = view.target + view.back * distance;
    lens.forward = -view.back;
    lens.up = view.up;
    lens.right = glm::normalize(glm::cross(lens.forward, lens.up));
    lens.up = glm::cross(lens.right, lens.forward);
    lens.orthographic = view.orthographic;
    lens.half_height = tan_half(view.fov_deg) * (view.orthographic ? std::abs(distance) : 1.0);
    lens.target_distance = std::abs(distance);
    lens.focus = lens.target_distance;
    return lens;
}

bool sane_fov(double fov_deg) { return fov_deg > 0 && fov_deg < 180; }

}  // namespace

Result<Lens> resolve_camera(const CameraSpec& spec, const std::optional<Camera>& scene, const ViewVariables& variables, const Bounds& bounds, double aspect) {
    const Box box = framed_box(bounds);
    const bool from_scene = spec.numbers.empty() && scene;
    Result<View> view = view_of_variables(variables, box);
    if (!spec.numbers.empty()) view = named_view(spec.numbers, variables.fov_deg.value_or(kDefaultFov));
    if (from_scene) view = vector_view(scene->eye, scene->target, scene->up, scene->fov_deg);
    if (!view) return tl::unexpected<Error>(view.error());
    if (!sane_fov(view->fov_deg)) return fail(Fault::kScene, fmt::format("The camera's field of view is {} degrees: it must lie between 0 and 180", view->fov_deg));
    if (!finite(view->target) || !finite(view->back) || !std::isfinite(view->distance.value_or(0))) return fail(Fault::kScene, "The view variables are not finite");
    view->orthographic = spec.orthographic.value_or(from_scene && scene->orthographic);
    if (spec.autocenter) view->target = box.centre;
    if (spec.viewall) view->distance.reset();
    Lens lens = lens_of(*view, box, aspect);
    if (!from_scene) return lens;
    lens.exposure = scene->exposure;
    lens.aperture = std::max(0.0, scene->aperture);
    lens.blades = scene->blades;
    lens.focus = scene->focus.value_or(lens.target_distance);
    return lens;
}

Ray camera_ray(const Lens& lens, double x, double y) {
    Ray ray;
    if (lens.orthographic) {
        ray.origin = lens.eye + lens.half_height * (x * lens.right + y * lens.up);
        ray.direction = lens.forward;
        return ray;
    }
    ray.origin = lens.eye;
    ray.direction = glm::normalize(lens.forward + lens.half_height * (x * lens.right + y * lens.up));
    return ray;
}

namespace {

// A point of the aperture, equal areas, in the lens's plane. A polygon stands on a side.
Vec2 on_aperture(const Lens& lens, Vec2 u) {
    const double radius = lens.aperture / 2;
    if (lens.blades < 3) return radius * std::sqrt(u.x) * on_circle(u.y);
    const double scaled = u.y * lens.blades, side = std::floor(scaled), across = scaled - side, out = std::sqrt(u.x);
    const auto corner = [&](double k) { return on_circle((k - 0.5) / lens.blades - 0.25); };
    return radius * out * glm::mix(corner(side), corner(side + 1), across);
}

Vec3 in_world(const Lens& lens, Vec2 v) { return v.x * lens.right + v.y * lens.up; }

}  // namespace

Ray camera_ray(const Lens& lens, double x, double y, Vec2 u) {
    Ray ray = camera_ray(lens, x, y);
    if (lens.aperture <= 0) return ray;
    const Vec3 sharp = ray.origin + ray.direction * (lens.focus / glm::dot(ray.direction, lens.forward));
    ray.origin += in_world(lens, on_aperture(lens, u));
    ray.direction = glm::normalize(sharp - ray.origin);
    return ray;
}

std::optional<Sighting> sighting(const Lens& lens, Vec3 point, Vec2 u) {
    const Vec2 offset = lens.aperture > 0 ? on_aperture(lens, u) : Vec2(0);
    const Vec3 from_eye = point - lens.eye;
    const double ahead = glm::dot(from_eye, lens.forward);
    if (!(ahead > 0)) return std::nullopt;
    // The ray from the lens through the point meets the plane of focus where the pinhole ray of its place in the picture does.
    const Vec2 across{glm::dot(from_eye, lens.right), glm::dot(from_eye, lens.up)};
    Sighting s;
    if (lens.orthographic) {
        // All rays through this place of the lens are parallel.
        const Vec2 place = lens.aperture > 0 ? across - offset * (1 - ahead / lens.focus) : across;
        s.eye = lens.eye + in_world(lens, place + offset);
        s.x = place.x / lens.half_height, s.y = place.y / lens.half_height;
        const double cosine = glm::dot(glm::normalize(point - s.eye), lens.forward);
        s.radiance_per_intensity = 1 / (cosine * lens.half_height * lens.half_height);
        return s;
    }
    s.eye = lens.eye + in_world(lens, offset);
    const Vec2 sharp = lens.aperture > 0 ? offset / lens.focus + (across - offset) / ahead : across / ahead;
    s.x = sharp.x / lens.half_height, s.y = sharp.y / lens.half_height;
    const Vec3 to = point - s.eye;
    const double d2 = glm::dot(to, to), cosine = ahead / std::sqrt(d2);
    s.radiance_per_intensity = 1 / (d2 * cosine * cosine * cosine * lens.half_height * lens.half_height);
    return s;
}

}  // namespace whittle
