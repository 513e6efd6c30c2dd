// builtin_module_parts.h — the built-in modules that make nodes, for the table in builtin_modules.cpp, and how they read arguments. Internal to csg/eval.
#pragma once

#include "csg/eval/builtin.h"
#include "csg/eval/machine.h"

namespace whittle {

using Made = std::optional<scene::What>;

// A finite number.
bool read_number(const Value& value, double& out);
// Two or three finite numbers; a missing third is `otherwise`. `out` is changed only on success.
bool read_vec3(const Value& value, Vec3& out, double otherwise);
bool read_vec2(const Value& value, Vec2& out);
int read_convexity(const Value& value, int otherwise);
// Any form that color() takes; warns where it is none.
std::optional<Vec4> read_color(ModuleUse& use, const Value& value);
// Rotation of rotate(a, v): [x, y, z] or an angle about an axis; warns where it is none.
Placement read_rotation(ModuleUse& use, const Value& a, const Value& v);

Made make_cube(ModuleUse& use);
Made make_sphere(ModuleUse& use);
Made make_cylinder(ModuleUse& use);
Made make_polyhedron(ModuleUse& use);
Made make_square(ModuleUse& use);
Made make_circle(ModuleUse& use);
Made make_polygon(ModuleUse& use);
Made make_torus(ModuleUse& use);
Made make_ellipsoid(ModuleUse& use);
Made make_halfspace(ModuleUse& use);
Made make_quadric(ModuleUse& use);
Made make_capsule(ModuleUse& use);
Made make_roundcube(ModuleUse& use);

Made make_translate(ModuleUse& use);
Made make_rotate(ModuleUse& use);
Made make_scale(ModuleUse& use);
Made make_mirror(ModuleUse& use);
Made make_multmatrix(ModuleUse& use);
Made make_resize(ModuleUse& use);
Made make_color(ModuleUse& use);
Made make_linear_extrude(ModuleUse& use);
Made make_rotate_extrude(ModuleUse& use);
Made make_offset(ModuleUse& use);

Made make_text(ModuleUse& use);
Made make_import(ModuleUse& use);
// The drawing of linear_extrude(file=) and its like, as the child import() that it stands for.
void add_drawing(ModuleUse& use, const Value& file, const Value& layer, const Value& origin, double scale);
Made make_surface(ModuleUse& use);

Made make_material(ModuleUse& use);
Made make_part(ModuleUse& use);
Made make_moving(ModuleUse& use);
Made make_light(ModuleUse& use);
Made make_sun(ModuleUse& use);
Made make_area_light(ModuleUse& use);
Made make_environment(ModuleUse& use);
Made make_camera(ModuleUse& use);

}  // namespace whittle
