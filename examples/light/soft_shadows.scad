// Lamps with a size: a ball, a rectangle and the sun throw shadows whose edges widen with the distance.
include <whittle.scad>

module post(h, c) material("plastic", color = c) {
    cylinder(h = h, r = 3);
    translate([0, 0, h]) sphere(5);
}
translate([-40, 0, 0]) post(24, [0.85, 0.3, 0.2]);
post(34, [0.9, 0.7, 0.2]);
translate([40, 0, 0]) post(44, [0.25, 0.5, 0.75]);
material("plastic", color = [0.5, 0.55, 0.5]) for (i = [0:8]) translate([-60 + 15 * i, -34, 0]) cube([5, 3, 16]);
material("matte", color = [0.88, 0.87, 0.84]) translate([-300, -300, -2]) cube([600, 600, 2]);

light(p = [110, -90, 120], r = 12, power = 7e5, color = [1, 0.86, 0.7]);
area_light(p = [-130, -110, 90], u = [40, -30, 0], v = [0, 0, 60], power = 3.5e5, color = [0.72, 0.84, 1]);
camera(eye = [-30, -190, 120], target = [0, 0, 10], fov = 34);
