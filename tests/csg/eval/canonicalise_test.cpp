#include "csg/eval/canonicalise.h"
#include "csg/eval/large_stack.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "csg/base/degrees.h"
#include "csg/solid/profile.h"

using namespace whittle;

namespace {

// A scene written by hand: every call adds a node and returns its id.
class Author {
public:
    SceneNodeId add(scene::What what, std::vector<SceneNodeId> children = {}, double fn = 0, std::uint8_t modifiers = 0) {
        SceneNode node;
        node.what = std::move(what);
        node.children = std::move(children);
        node.place = {0, static_cast<std::uint32_t>(scene_.nodes.size() + 1), 1};
        node.facets.fn = fn;
        node.modifiers = modifiers;
        scene_.nodes.push_back(std::move(node));
        return static_cast<SceneNodeId>(scene_.nodes.size() - 1);
    }
    SceneNodeId at(Vec3 v, SceneNodeId child) { return add(scene::Transform{Placement::translation(v)}, {child}); }
    Canonical canonical(std::vector<SceneNodeId> children, const CanonicaliseOptions& options = {}, Outside* outside = nullptr) {
        scene_.root = add(scene::Group{"group"}, std::move(children));
        return canonicalise(scene_, options, outside, diagnostics);
    }
    bool said(const std::string& text) const {
        return std::any_of(diagnostics.all().begin(), diagnostics.all().end(), [&](const Diagnostic& d) { return d.text.find(text) != std::string::npos; });
    }
    Diagnostics diagnostics;

private:
    Scene scene_;
};

template <class T>
const T& root_as(const Canonical& c) {
    return std::get<T>(c.solid.node(c.solid.root().node));
}
template <class T>
const T& root_shape(const Canonical& c) {
    return std::get<T>(root_as<Shape>(c));
}
bool is_empty(const Canonical& c) { return c.solid.root().node == kEmptyNode; }

const scene::Cube kCube{Vec3(10), false};

}  // namespace

TEST_CASE("primitives become the true shapes") {
    Author a;
    CHECK(root_shape<shape::Box>(a.canonical({a.add(scene::Cube{{1, 2, 3}, true})})) == shape::Box{{-0.5, -1, -1.5}, {0.5, 1, 1.5}});
    CHECK(root_shape<shape::Ellipsoid>(a.canonical({a.add(scene::Sphere{4})})) == shape::Ellipsoid{Vec3(4)});
    CHECK(root_shape<shape::Frustum>(a.canonical({a.add(scene::Cylinder{10, 5, 1, true})})) == shape::Frustum{-5, 5, 5, 1});
    CHECK(root_shape<shape::HalfSpace>(a.canonical({a.add(scene::Quadric{{0, 0, 0, 0, 0, 0, 1, 0, 0, -3}})})) == shape::HalfSpace{{1, 0, 0}, 3});
    CHECK(root_shape<shape::Ellipsoid>(a.canonical({a.add(scene::Torus{0, 2})})) == shape::Ellipsoid{Vec3(2)});
    CHECK(root_shape<shape::Box>(a.canonical({a.add(scene::RoundCube{Vec3(2), 0, false})})) == shape::Box{Vec3(0), Vec3(2)});
    CHECK(a.diagnostics.all().empty());
}

TEST_CASE("$fn asks for facets, and --curves overrides") {
    Author a;
    CanonicaliseOptions exact, faceted;
    exact.curves = Curves::kExact;
    faceted.curves = Curves::kFaceted;
    const auto ball = [&](double fn) { return a.add(scene::Sphere{10}, {}, fn); };
    CHECK(root_shape<shape::FacetedBall>(a.canonical({ball(7)})).n == 7);
    CHECK(root_shape<shape::FacetedBall>(a.canonical({ball(30.9)})).n == 30);
    CHECK(root_shape<shape::FacetedBall>(a.canonical({ball(2)})).n == 3);
    CHECK(root_shape<shape::Ellipsoid>(a.canonical({ball(-5)})).radii.x == 10);
    CHECK(a.diagnostics.all().empty());
    CHECK(root_shape<shape::Ellipsoid>(a.canonical({ball(32)}, exact)).radii.x == 10);
    CHECK(root_shape<shape::FacetedBall>(a.canonical({ball(31)}, exact)).n == 31);
    CHECK(root_shape<shape::FacetedBall>(a.canonical({ball(0)}, faceted)).n == 30);
}

TEST_CASE("facets beyond all memory become the true curve") {
    Author a;
    CHECK(root_shape<shape::Disc>(a.canonical({a.add(scene::Circle{10}, {}, 1e300)})).r == 10);
    CHECK(a.said("More than 65536 facets asked for, made a true curve"));
}

TEST_CASE("many facets are noted once, with their number") {
    Author a;
    a.canonical({a.add(scene::Sphere{10}, {}, 100), a.add(scene::Cylinder{}, {}, 64), a.add(scene::Circle{}, {}, 8)});
    REQUIRE(a.said("$fn=100 asks for facets (2 solids); --curves=exact shows true curves"));
    CHECK(a.diagnostics.count(Severity::kNote) == 1);
}

TEST_CASE("sizes that make nothing are left out with a message") {
    Author a;
    const double nan = std::nan("");
    const std::vector<scene::What> nothing = {scene::Cube{{0, 1, 1}, false}, scene::Sphere{-1}, scene::Cylinder{0, 1, 1, false}, scene::Cylinder{1, -1, 1, false},
                                              scene::Cylinder{1, 0, 0, false}, scene::Sphere{nan}, scene::Torus{3, 0}, scene::HalfSpace{Vec3(0), 1},
                                              scene::RoundCube{Vec3(1), 0.6, false}, scene::Capsule{Vec3(0), {0, 0, nan}, 1}, scene::Square{{1, 0}, false},
                                              scene::Circle{0}, scene::Ellipsoid{{1, 0, 1}}};
    for (const auto& what : nothing) {
        Author b;
        const Canonical c = b.canonical({b.add(what)});
        CHECK(is_empty(c));
        CHECK(c.something_left_out);
        CHECK(b.diagnostics.count(Severity::kWarning) == 1);
        CHECK(b.diagnostics.all()[0].place.line == 1);
    }
}

TEST_CASE("a zero scale removes the object with OpenSCAD's words") {
    Author a;
    const Placement flat{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}};
    CHECK(is_empty(a.canonical({a.add(scene::Transform{flat}, {a.add(kCube)})})));
    CHECK(a.said("Scaling a 3D object with 0 - removing object"));
    const Placement thin{{0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
    CHECK(is_empty(a.canonical({a.add(scene::Transform{thin}, {a.add(scene::Square{})})})));
    CHECK(a.said("Scaling a 2D object with 0 - removing object"));
    CHECK_FALSE(is_empty(a.canonical({a.add(scene::Transform{flat}, {a.add(scene::Square{})})})));
}

TEST_CASE("empty children empty an intersection and a difference they lead") {
    Author a;
    const auto none = [&] { return a.add(scene::Group{"module"}); };
    CHECK(is_empty(a.canonical({a.add(scene::Difference{}, {none(), a.add(kCube)})})));
    CHECK(is_empty(a.canonical({a.add(scene::Intersection{}, {a.add(kCube), none()})})));
    CHECK_FALSE(is_empty(a.canonical({a.add(scene::Difference{}, {a.add(kCube), none()})})));
    CHECK_FALSE(is_empty(a.canonical({a.add(scene::Union{}, {none(), a.add(kCube)})})));
}

TEST_CASE("a group counts as one child of a difference") {
    Author a;
    const SceneNodeId loop = a.add(scene::Group{"for"}, {a.add(kCube), a.at({20, 0, 0}, a.add(kCube))});
    const Canonical c = a.canonical({a.add(scene::Difference{}, {loop, a.add(scene::Sphere{3})})});
    const auto& difference = root_as<Combination>(c);
    REQUIRE(difference.op == SetOp::kDifference);
    CHECK(difference.operands.size() == 2);
    CHECK(c.solid.root_bounds() == Bounds{{0, 0, 0}, {30, 10, 10}});
}

TEST_CASE("the first child decides between 2D and 3D") {
    Author a;
    const Canonical c = a.canonical({a.add(kCube), a.add(scene::Square{}), a.add(scene::Circle{})});
    CHECK_FALSE(c.is_2d);
    CHECK(c.something_left_out);
    CHECK(a.said("Mixing 2D and 3D objects is not supported"));
    CHECK(a.said("Ignoring 2D child object for 3D operation"));
    CHECK(a.diagnostics.all().size() == 3);
    Author b;
    CHECK(b.canonical({b.add(scene::Square{}), b.add(kCube)}).is_2d);
    CHECK(b.said("Ignoring 3D child object for 2D operation"));
}

TEST_CASE("a background part is no operand; a highlighted one stays") {
    Author a;
    CHECK(is_empty(a.canonical({a.add(kCube, {}, 0, kBackground)})));
    const SceneNodeId less = a.add(scene::Difference{}, {a.add(scene::Sphere{1}, {}, 0, kBackground), a.add(kCube), a.add(scene::Sphere{2}, {}, 0, kHighlight)});
    const Canonical c = a.canonical({less});
    CHECK(root_as<Combination>(c).operands.size() == 2);
    CHECK(c.solid.root_bounds() == Bounds{Vec3(0), Vec3(10)});
}

TEST_CASE("a preview shows background and highlight where they stand") {
    Author a;
    CanonicaliseOptions preview;
    preview.preview = true;
    const SceneNodeId ghost = a.at({50, 0, 0}, a.add(kCube, {}, 0, kBackground));
    const Canonical c = a.canonical({a.add(kCube), ghost}, preview);
    CHECK(c.solid.root_bounds() == Bounds{Vec3(0), {60, 10, 10}});
    CHECK(a.canonical({a.add(kCube), ghost}).solid.root_bounds() == Bounds{Vec3(0), Vec3(10)});
}

TEST_CASE("a preview of nothing but ghosts keeps to one dimension") {
    Author a;
    CanonicaliseOptions preview;
    preview.preview = true;
    const Canonical c = a.canonical({a.add(scene::Square{}, {}, 0, kBackground), a.add(kCube, {}, 0, kBackground)}, preview);
    CHECK(c.is_2d);
    CHECK(c.solid.root_bounds() == Bounds{Vec3(0), {1, 1, 0}});
}

TEST_CASE("the outermost colour wins and leaves know their place") {
    Author a;
    const SceneNodeId inner = a.add(scene::Color{{0, 0, 1, 1}}, {a.add(kCube)});
    const Canonical c = a.canonical({a.add(scene::Color{{1, 0, 0, 1}}, {inner})});
    const Label& label = c.solid.label(c.solid.root().label);
    CHECK(*label.material.color == Vec4(1, 0, 0, 1));
    CHECK(label.place.line == 1);
}

TEST_CASE("an alpha alone keeps the inner colour") {
    Author a;
    const SceneNodeId inner = a.add(scene::Color{{0, 0, 1, 1}}, {a.add(kCube)});
    const Canonical c = a.canonical({a.add(scene::Color{{-1, -1, -1, 0.25}}, {inner})});
    CHECK(*c.solid.label(c.solid.root().label).material.color == Vec4(0, 0, 1, 0.25));
}

TEST_CASE("parts carry their names") {
    Author a;
    const Canonical c = a.canonical({a.add(scene::Part{"lid"}, {a.add(kCube)})});
    CHECK(c.solid.label(c.solid.root().label).part == "lid");
}

TEST_CASE("an extrusion that shrinks evenly makes cones of its circles, leaning where they are off the axis") {
    scene::LinearExtrude up;
    up.height = 10;
    up.scale = {0.5, 0.5};
    Author upright;
    CHECK(root_shape<shape::Frustum>(upright.canonical({upright.add(up, {upright.add(scene::Circle{4})})})) == shape::Frustum{0, 10, 4, 2});
    Author leaning;
    const Canonical c = leaning.canonical({leaning.add(up, {leaning.at({6, 8, 0}, leaning.add(scene::Circle{4}))})});
    const Use cone = c.solid.root();
    CHECK(root_shape<shape::Frustum>(c) == shape::Frustum{0, 10, 4, 2});
    CHECK(apply_to_point(cone.placement, {4, 0, 0}) == Vec3(10, 8, 0));
    CHECK(glm::length(apply_to_point(cone.placement, {2, 0, 10}) - Vec3(5, 4, 10)) < 1e-14);
    Author ring;
    const Canonical r = ring.canonical({ring.add(up, {ring.add(scene::Difference{}, {ring.add(scene::Circle{4}), ring.add(scene::Circle{1})})})});
    CHECK(root_as<Combination>(r).op == SetOp::kDifference);
    up.scale = {0.5, 1};
    Author uneven;
    CHECK(root_shape<shape::Extrusion>(uneven.canonical({uneven.add(up, {uneven.add(scene::Circle{4})})})).scale_top == Vec2(0.5, 1));
}

TEST_CASE("an extrusion along a vector leans, about the plane z = 0") {
    scene::LinearExtrude up;
    up.height = 8;
    up.lean = {0.25, 0.5};
    Author a;
    CHECK(a.canonical({a.add(up, {a.add(scene::Square{{2, 3}, false})})}).solid.root_bounds() == Bounds{Vec3(0), {4, 7, 8}});
    up.center = true;
    Author centred;
    CHECK(centred.canonical({centred.add(up, {centred.add(scene::Square{{2, 3}, false})})}).solid.root_bounds() == Bounds{{-1, -2, -4}, {3, 5, 4}});
}

TEST_CASE("upright extrusions of simple outlines are boxes and cylinders") {
    Author a;
    scene::LinearExtrude up;
    up.height = 5;
    CHECK(root_shape<shape::Box>(a.canonical({a.add(up, {a.add(scene::Square{{2, 3}, false})})})) == shape::Box{Vec3(0), {2, 3, 5}});
    CHECK(root_shape<shape::Frustum>(a.canonical({a.add(up, {a.add(scene::Circle{2})})})) == shape::Frustum{0, 5, 2, 2});
    up.height = 0;
    CHECK(is_empty(a.canonical({a.add(up, {a.add(scene::Square{})})})));
}

TEST_CASE("segments divide the sides of a sliced extrusion, and of no other") {
    Author a;
    const auto corners = [&](std::optional<int> slices, double twist_deg, Vec2 scale) {
        scene::LinearExtrude up;
        up.height = 5;
        up.twist_deg = twist_deg;
        up.scale = scale;
        up.slices = slices;
        up.segments = 12;
        const Canonical made = a.canonical({a.add(up, {a.add(scene::Square{{2, 2}, false})})});
        const auto contours = contours_of(made.solid, root_shape<shape::Extrusion>(made).profile, 1e-9);
        return contours.size() == 1 ? contours[0].size() : 0;
    };
    CHECK(corners(7, 90, Vec2(1)) == 12);
    CHECK(corners(7, 0, Vec2(1, 3)) == 10);  // one more cut each for all four would be too many
    CHECK(corners({}, 90, Vec2(1)) == 4);
    CHECK(corners(7, 0, Vec2(0.5)) == 4);
}

TEST_CASE("twists are smooth by default, sliced by $fn or slices") {
    Author a;
    const auto slices = [&](std::optional<int> given, double fn) {
        scene::LinearExtrude twist;
        twist.height = 5;
        twist.twist_deg = 90;
        twist.slices = given;
        return root_shape<shape::Extrusion>(a.canonical({a.add(twist, {a.add(scene::Square{{2, 3}, false})}, fn)})).slices;
    };
    CHECK(slices({}, 0) == 0);
    CHECK(slices(7, 0) == 7);
    CHECK(slices({}, 20) == 5);
}

TEST_CASE("a turned disc is a torus, a turned half disc stays beside the axis") {
    Author a;
    const scene::RotateExtrude turn;
    const Canonical ring = a.canonical({a.add(turn, {a.at({10, 4, 0}, a.add(scene::Circle{2}))})});
    CHECK(root_shape<shape::Torus>(ring) == shape::Torus{10, 2});
    CHECK(ring.solid.root().placement == Placement::translation({0, 0, 4}));
    const SceneNodeId half = a.add(scene::Difference{}, {a.add(scene::Circle{5}), a.at({-20, -10, 0}, a.add(scene::Square{{20, 20}, false}))});
    const Canonical ball = a.canonical({a.add(turn, {half})});
    const NodeId profile = root_shape<shape::Revolution>(ball).profile;
    CHECK(ball.solid.bounds(profile).lo.x == 0);
    CHECK(a.diagnostics.all().empty());
    CHECK(is_empty(a.canonical({a.add(turn, {a.add(scene::Circle{5})})})));
    CHECK(a.said("all points for rotate_extrude() must have the same X coordinate sign"));
}

TEST_CASE("a profile left of the axis turns as its mirror image half a turn away") {
    Author a;
    scene::RotateExtrude turn;
    turn.angle_deg = 90;
    turn.start_deg = 0;
    const auto box = a.canonical({a.add(turn, {a.at({-4, 0, 0}, a.add(scene::Square{{2, 1}, false}))})}).solid.root_bounds();
    CHECK(box.lo.x == Approx(-4));
    CHECK(box.lo.y == Approx(-4));
    CHECK(box.hi.x == Approx(0).margin(1e-9));
    turn.angle_deg = -90;
    const auto other = a.canonical({a.add(turn, {a.at({2, 0, 0}, a.add(scene::Square{{2, 1}, false}))})}).solid.root_bounds();
    CHECK(other.lo.y == Approx(-4));
    CHECK(other.hi.x == Approx(4));
}

TEST_CASE("a polyhedron's faces are turned to counter-clockwise") {
    Author a;
    scene::Polyhedron corner;
    corner.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    corner.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};  // clockwise from outside
    const Canonical c = a.canonical({a.add(corner)});
    const auto& facet = root_shape<shape::Polyhedron>(c).mesh->facets[0];
    const auto& points = root_shape<shape::Polyhedron>(c).mesh->points;
    CHECK(glm::cross(points[facet[1]] - points[facet[0]], points[facet[2]] - points[facet[0]]).z < 0);
    CHECK(a.diagnostics.all().empty());
    for (auto& face : corner.faces) std::reverse(face.begin(), face.end());
    CHECK(root_shape<shape::Polyhedron>(a.canonical({a.add(corner)})).mesh->facets.size() == 4);
    CHECK(a.said("inside out"));
}

TEST_CASE("an open polyhedron says how many edges are open") {
    Author a;
    scene::Polyhedron open;
    open.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    open.faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}};
    const Canonical c = a.canonical({a.add(open)});
    CHECK(is_empty(c));
    CHECK(c.something_left_out);
    CHECK(a.said("polyhedron() is not closed (3 open edges), left out"));
    open.faces.push_back({1, 7, 2});
    a.canonical({a.add(open)});
    CHECK(a.said("Point index 7 is out of bounds"));
}

TEST_CASE("what needs meshes or fonts is left out where there are none, and said at its place") {
    Author a;
    scene::Text text;
    text.request.text = "a";
    scene::Unsupported file;
    file.name = "linear_extrude(file)";
    const SceneNodeId cube = a.add(kCube), ring = a.add(scene::Torus{50, 10}), other = a.at({9, 0, 0}, a.add(scene::Torus{50, 10}));
    const SceneNodeId hull = a.add(scene::Hull{}, {a.add(scene::Difference{}, {ring, other})});
    const Canonical c = a.canonical({cube, hull, a.add(text), a.add(file)});
    CHECK(c.something_left_out);
    CHECK(c.solid.root_bounds() == Bounds{Vec3(0), Vec3(10)});
    CHECK(a.said("hull() cannot be made, left out"));
    CHECK(a.said("text() needs fonts, left out"));
    CHECK(a.said("linear_extrude(file)() is not supported yet, left out"));
    CHECK(a.diagnostics.all()[0].place.line == 6);
}

TEST_CASE("resize scales to the size asked for, and the rest along where told") {
    Author a;
    scene::Resize to;
    to.size = {20, 0, 0};
    to.automatic = {false, true, false};
    const Bounds box = a.canonical({a.add(to, {a.add(scene::Sphere{5})})}).solid.root_bounds();
    CHECK(box.hi == Vec3(10, 10, 5));
}

TEST_CASE("a thousand equal cubes are one shape and a thousand uses") {
    Author a;
    std::vector<SceneNodeId> cubes;
    for (int i = 0; i < 1000; ++i) cubes.push_back(a.at({20.0 * i, 0, 0}, a.add(kCube)));
    const Canonical c = a.canonical(cubes);
    CHECK(c.solid.node_count() == 3);
    CHECK(root_as<Combination>(c).operands.size() == 1000);
}

TEST_CASE("a scene a hundred thousand levels deep becomes a solid") {
    Author a;
    SceneNodeId inner = a.add(kCube);
    const Placement turned{{0.8, -0.6, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0}};
    const int levels = kLargeStackBytes < std::size_t{1} << 30 ? 5000 : 100000;  // the address sanitizer allows a small stack only
    for (int i = 0; i < levels; ++i) inner = a.add(scene::Difference{}, {a.add(scene::Transform{turned}, {inner}), a.add(scene::Sphere{1})});
    const Canonical c = a.canonical({inner});
    CHECK(c.solid.node_count() > static_cast<std::size_t>(levels));
}

TEST_CASE("growing a square rounds its corners with true arcs, shrinking takes strips away") {
    Author a;
    const auto grown = [&](double delta, bool round) { return a.canonical({a.add(scene::Offset{delta, round, false}, {a.add(scene::Square{{4, 2}, false})})}); };
    const Canonical larger = grown(1, true);
    REQUIRE(larger.is_2d);
    CHECK(larger.solid.root_bounds() == Bounds{{-1, -1, 0}, {5, 3, 0}});
    CHECK(root_as<Combination>(larger).operands.size() == 1 + 4 + 4);
    const Canonical smaller = grown(-0.5, true);
    CHECK(root_as<Combination>(smaller).op == SetOp::kDifference);
    CHECK(root_as<Combination>(smaller).operands.size() == 1 + 4);
    const Canonical mitered = grown(1, false);
    CHECK(root_shape<shape::Polygon>(mitered).contours->at(0).size() == 4);
    CHECK(mitered.solid.root_bounds() == Bounds{{-1, -1, 0}, {5, 3, 0}});
    CHECK(is_empty(grown(-1.5, false)));
    CHECK(root_shape<shape::Disc>(a.canonical({a.add(scene::Offset{2, true, false}, {a.add(scene::Circle{3})})})) == shape::Disc{5});
    CHECK(a.diagnostics.all().empty());
}
