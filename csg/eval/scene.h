// scene.h — the evaluated scene: a tree that keeps what the author wrote (places in the text, colours, modifiers, author's order).
//
// The evaluator makes it, canonicalise (csg/eval/canonicalise.h) turns it into the solid. Nothing here is simplified: a `.csg` dump is a walk over it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "csg/base/vec.h"
#include "csg/eval/matter.h"
#include "csg/eval/node_list.h"
#include "csg/lang/source.h"
#include "csg/solid/text_outline.h"

namespace whittle {

using SceneNodeId = std::uint32_t;

// $fn, $fa, $fs in force where a node was evaluated.
struct Facets { double fn = 0, fa = 12, fs = 2, fe = 0; bool operator==(const Facets&) const = default; };

namespace scene {

// Primitives: lengths in mm, as given, already converted and defaulted. Sizes may be <= 0 or not finite: canonicalise drops those with a message.
struct Cube { Vec3 size{1}; bool center = false; };
struct Sphere { double r = 1; };
struct Cylinder { double h = 1, r1 = 1, r2 = 1; bool center = false; };
struct Polyhedron {
    std::vector<Vec3> points;
    std::vector<std::vector<std::int64_t>> faces;
    int convexity = 1;
    bool given_points = false, given_faces = false;  // by the author, perhaps as []
};  // faces clockwise from outside
struct Square { Vec2 size{1}; bool center = false; };
struct Circle { double r = 1; };
struct Polygon {
    std::vector<Vec2> points;
    std::vector<std::vector<std::int64_t>> paths;
    int convexity = 1;
    bool given_points = false, given_paths = false;  // likewise
};  // no paths: all points in order
struct Torus { double r1 = 1, r2 = 0.5; };
struct Ellipsoid { Vec3 r{1}; };
struct HalfSpace { Vec3 n{0, 0, 1}; double d = 0; };
struct Quadric { std::array<double, 10> c{}; };
struct Capsule { Vec3 p{0}, q{0, 0, 1}; double r = 1; };
struct RoundCube { Vec3 size{1}; double r = 0; bool center = false; };

// Maps and operations; the operands are the node's children (each container is an implicit union of them).
struct Group { std::string name; };  // "group", a user module, for, if, children ... 
struct Union {};
struct Difference {};
struct Intersection {};
struct Hull {};
struct Minkowski { int convexity = 0; };
struct Transform { Placement placement; };
struct Color { Vec4 rgba{1}; };          // alpha included; a component of -1: not set by this color()
struct Matter { Material material; };
// `lean`: how far the top is moved sideways for each mm of height (the vector v of later versions).
struct LinearExtrude {
    double height = 100;
    bool center = false;
    double twist_deg = 0;
    Vec2 scale{1};
    std::optional<int> slices;
    int segments = 0;  // pieces that a contour's sides are cut into where there are slices; 0: the sides as they are
    int convexity = 1;
    Vec2 lean{0};
};
struct RotateExtrude { double angle_deg = 360; double start_deg = 180; int convexity = 2; };
struct Render { int convexity = 1; };
struct Resize { Vec3 size{0}; std::array<bool, 3> automatic{}; int convexity = 0; };
struct Offset { double delta = 0; bool round = true; bool chamfer = false; };
struct Projection { bool cut = false; int convexity = 0; };
struct Fill {};
struct Roof { std::string method; int convexity = 1; };
struct Text { TextRequest request; std::string csg; };
struct Part { std::string name; };
struct Moving { Placement start, end; };

// A mesh or drawing of a file; `path` as it was found. `csg` is how a .csg file writes it. The file is read when the solid is made.
struct Import { std::string path, name, layer; Vec2 origin{0}; double scale = 1; bool center = false; double dpi = 72; std::string csg; };
// Heights of a file, on the unit grid.
struct Surface { std::string path, name; bool center = false, invert = false; std::string csg; };

// A module that is known but cannot be made into a solid yet: kept in the tree so that it can be said with its place.
// `csg` is how a .csg file writes it, without children.
struct Unsupported { std::string name; std::string csg; };

// What few nodes are and needs much room stands in a box; everything else fits in the 96 bytes of a placement.
using What = std::variant<Group, Cube, Sphere, Cylinder, Polyhedron, Square, Circle, Polygon, Torus, Ellipsoid, HalfSpace, Quadric, Capsule, RoundCube,
                          Union, Difference, Intersection, Hull, Minkowski, Transform, Color, Boxed<Matter>, LinearExtrude, RotateExtrude, Render, Resize, Offset,
                          Projection, Fill, Roof, Boxed<Text>, Part, Boxed<Moving>, Boxed<Import>, Boxed<Surface>, Unsupported>;
static_assert(sizeof(What) <= 104);

}  // namespace scene

enum Modifier : std::uint8_t { kBackground = 1, kHighlight = 2, kRoot = 4 };  // %, #, !

struct SceneNode {
    scene::What what;
    ChildIds children;
    SourcePlace place;
    Facets facets;
    std::uint8_t modifiers = 0;
};

// View variables assigned at file level ($vpr, $vpt, $vpd, $vpf); unset where the author said nothing.
struct ViewVariables { std::optional<Vec3> rotation_deg, target; std::optional<double> distance, fov_deg; };

struct Scene {
    BlockList<SceneNode> nodes;  // children before parents is not promised; ids index this
    SceneNodeId root = 0;          // always a Group; a `!` is already resolved: the root is then a group around that node
    std::vector<Light> lights;
    std::optional<Camera> camera;
    ViewVariables view;
    std::vector<std::string> fonts;  // files that `use` named
};

}  // namespace whittle
