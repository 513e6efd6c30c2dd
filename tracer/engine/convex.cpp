#include "tracer/engine/convex.h"

#include <algorithm>
#include <cmath>

#include "csg/solid/convex_line.h"
#include "csg/span/perturbation.h"

namespace whittle {

namespace {

// Of the body's size: how far outside of a flat face the body's own crossing is put. More than snapping moves planes by.
constexpr double kOutside = 0x1p-26;

// Of the body's size: more than snapping moves its planes by, were they a neighbour's sixteen times as large.
constexpr double kMoved = 0x1p-40;

// How far into it a line almost in a face's plane is moved where double cannot tell: more than that, and than it is moved by otherwise.
constexpr double kInward = 0x1p-27;

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
double size_of(const std::array<double, 3>& v) { return glm::length(vector_of(v)); }

// Of the body's size: a border that is less certain than this along the ray may be anywhere in a flat face or beside it.
constexpr double kAlong = 0x1p-20;
constexpr int kMostSteps = 64;

// Is the point, in the face's plane, deeper in the face than `room`? Two points of the face make a triangle with its middle; while that does not hold the point,
// what lies farthest across their line takes the place of one.
bool lies_within(const ConvexHullBody& body, const FlatFace& face, const Vec3& point, double room) {
    const Vec3 helper = std::abs(face.n.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), x = glm::normalize(glm::cross(helper, face.n)), y = glm::cross(face.n, x);
    const auto flat = [&](const Vec3& p) { return Vec2(glm::dot(p - face.middle, x), glm::dot(p - face.middle, y)); };
    const auto farthest = [&](const Vec2& way) { return flat(farthest_point(body.parts, body.size, face, way.x * x + way.y * y)); };
    const auto cross = [](const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; };
    const Vec2 q = flat(point);
    const double length = glm::length(q);
    const Vec2 way = length > room ? q / length : Vec2(1, 0);
    Vec2 a = farthest(way), b = farthest(cross(way, a) > 0 ? Vec2(way.y, -way.x) : Vec2(-way.y, way.x));
    for (int step = 0; step < kMostSteps; ++step) {
        Vec2 n(b.y - a.y, a.x - b.x);
        if (!(glm::length(n) > 0)) return false;
        n *= (glm::dot(n, way) < 0 ? -1 : 1) / glm::length(n);
        if (glm::dot(n, q - a) < -room) return true;
        const Vec2 w = farthest(n);
        if (!(glm::dot(n, q - w) < -room) || !(glm::dot(n, w - a) > room)) return false;
        ((cross(way, w) > 0) == (cross(way, a) > 0) ? a : b) = w;
    }
    return false;
}

// Is the border, which side 1 enters and -1 leaves, in a flat face? Then it goes outside; it is certain off the face's rim. A ray that runs almost in the face's
// plane or along what is beside it is not told apart: it keeps its border.
void yield_to_faces(const ConvexHullBody& body, const Vec3& o, const Vec3& d, double room, double side, ConvexSpan::Border& border) {
    for (const FlatFace& face : body.faces) {
        const double along = glm::dot(face.n, d);
        if (!(side * along < 0)) continue;
        const double t = (face.d - glm::dot(face.n, o)) / along, length = glm::length(d);
        const double rounding = (room + 0x1p-48 * (std::abs(face.d) + glm::length(o) + body.size)) / std::abs(along), window = border.error + rounding;
        if (!(std::abs(t - border.t) <= window)) continue;
        if (!(window * length <= kAlong * body.size)) {
            border.certain = false;
            continue;
        }
        border.t = t - side * kOutside * body.size / std::abs(along);
        border.error = rounding;
        border.certain = lies_within(body, face, o + t * d, 4 * window * length);
    }
}

// Inward, of length 1 each and added up: of the flat faces in whose planes the line almost runs, near the body. What double cannot tell there the planes decide, which
// are of the body's cell: the body itself only has to reach beyond them.
Vec3 inward_of_faces_along(const ConvexHullBody& body, const Vec3& o, const Vec3& d) {
    Vec3 inward(0);
    for (const FlatFace& face : body.faces) {
        const Vec3 from = o - face.middle;
        const bool along = std::abs(glm::dot(face.n, d)) <= kAlong * glm::length(d) && std::abs(glm::dot(face.n, from)) <= kAlong * (body.size + glm::length(from));
        if (along) inward -= face.n;
    }
    return inward;
}

// Is the line, which misses the body, so near it along a flat face that it meets it where the face is in a plane that the snap has moved outward?
bool may_meet_moved_face(const ConvexHullBody& body, const Vec3& o, const Vec3& d, double room) {
    return inward_of_faces_along(body, o, d) != Vec3(0) && span_on_line(body, o, d, room + kMoved * body.size).kind != ConvexSpan::Kind::kMissed;
}

// A ray square to the plane of a section is one place of the body: in it all along or nowhere. False: not told.
bool stands_in(const ConvexHullBody& body, const Vec3& place, double room, Crossings& out) {
    const ConvexSpan across = span_on_line(body, place, Vec3(1, 0, 0), room);
    out.count = 0;
    out.first_sign = 1;
    if (across.kind != ConvexSpan::Kind::kMet) return across.kind == ConvexSpan::Kind::kMissed;
    const double behind = across.in.t + across.in.error + room, ahead = across.out.t - across.out.error - room;
    if (behind < 0 && ahead > 0) {
        out.first_sign = -1;
        return true;
    }
    return across.in.t - across.in.error - room > 0 || across.out.t + across.out.error + room < 0;
}

// `certain` is false where the answer is no certificate.
bool crossings_of(const ConvexHullBody& body, const Vec3& o, const Vec3& d, double room, bool leaving, Crossings& out, bool& certain) {
    out.count = 0;
    out.first_sign = 1;
    certain = true;
    const double span = glm::length(o - body.middle) + body.size, length = glm::length(d);
    if (length == 0) return !leaving && stands_in(body, o, room, out);
    if (!std::isfinite(span / length) || !(room < 0x1p-14 * body.size)) return false;
    ConvexSpan found = span_on_line(body, o, d, room);
    if (found.kind == ConvexSpan::Kind::kUnclear) return false;
    if (found.kind == ConvexSpan::Kind::kMissed) return !leaving && !may_meet_moved_face(body, o, d, room);
    yield_to_faces(body, o, d, room, 1, found.in);
    yield_to_faces(body, o, d, room, -1, found.out);
    if (leaving) {
        ConvexSpan::Border& here = std::abs(found.in.t) < std::abs(found.out.t) ? found.in : found.out;
        here.t = here.error = 0;
        here.certain = true;
    }
    if (!(found.in.t + found.in.error < found.out.t - found.out.error)) return false;
    certain = found.in.certain && found.out.certain;
    out.count = 2;
    out.t[0] = found.in.t, out.error[0] = found.in.error;
    out.t[1] = found.out.t, out.error[1] = found.out.error;
    return true;
}

}  // namespace

bool convex_crossings(const Frame& frame, const FrameRay& ray, bool leaving, Crossings& out) {
    const ConvexHullBody& body = *frame.body;
    const Vec3 o = vector_of(ray.o), d = vector_of(ray.d);
    const double length = glm::length(d), far = length > 0 ? (glm::length(o - body.middle) + body.size) / length : 0;
    bool certain = false;
    return crossings_of(body, o, d, size_of(ray.eo) + far * size_of(ray.ed), leaving, out, certain) && certain;
}

void unsettled_convex(const Frame& frame, const Ray& ray, bool leaving, Crossings& out) {
    const ConvexHullBody& body = *frame.body;
    double scale = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) scale = std::max(scale, std::abs(frame.placement.linear(i, j)));
    const double size = body.size * scale;
    // The first by more than rounding and the snap part bodies that are meant to coincide: then they agree.
    for (const double share : {0x1p-40, 0x1p-36, 0x1p-32, 0x1p-30}) {
        Ray moved = ray;
        moved.origin += share * size / glm::length(kPerturbation[0]) * kPerturbation[0];
        const FrameRay local = ray_in_frame(frame, moved);
        const Vec3 o = vector_of(local.o), d = vector_of(local.d);
        bool certain = false;
        if (crossings_of(body, o + kInward * body.size * inward_of_faces_along(body, o, d), d, 0, leaving, out, certain)) return;
    }
    out.count = 0;
    out.first_sign = 1;
}

Vec3 convex_gradient(const Frame& frame, const Vec3& point) {
    const ConvexHullBody& body = *frame.body;
    const auto border = way_out(body, body.middle, point - body.middle);
    return border ? border->normal : point - body.middle;
}

Vec3 convex_middle(const Frame& frame) { return apply_to_point(frame.placement, frame.body->middle); }

double convex_distance(const Frame& a, const Frame& b) {
    const ConvexParts &p = a.body->parts, &q = b.body->parts;
    if (p.size() != q.size()) return HUGE_VAL;
    double worst = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p[i].images.size() != q[i].images.size()) return HUGE_VAL;
        double apart = glm::distance(apply_to_point(a.placement, p[i].centre), apply_to_point(b.placement, q[i].centre));
        for (std::size_t k = 0; k < p[i].images.size(); ++k)
            for (Vec3 BallImage::*column : {&BallImage::u, &BallImage::v, &BallImage::w})
                apart += glm::distance(apply_to_direction(a.placement, p[i].images[k].*column), apply_to_direction(b.placement, q[i].images[k].*column));
        worst = std::max(worst, apart);
    }
    return worst;
}

}  // namespace whittle
