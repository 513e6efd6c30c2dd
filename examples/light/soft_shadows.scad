// Lamps with a size: a warm ball and a cool rectangle throw shadows whose edges widen with the distance from what throws them.
include <whittle.scad>

module post(h, c) material("plastic", color = c, roughness = 0.3) {
    cylinder(h = h, r = 2.5);
    translate([0, 0, h + 4]) sphere(6);
}
translate([-38, 6, 0]) post(16, [0.8, 0.22, 0.14]);
translate([-4, 12, 0]) post(32, [0.88, 0.62, 0.12]);
translate([34, 10, 0]) post(48, [0.16, 0.4, 0.66]);
// A comb.
material("plastic", color = [0.86, 0.84, 0.8]) translate([-48, -30, 0]) {
    for (i = [0:16]) translate([6 * i, 0, 0]) cube([2.4, 3, 22]);
    translate([0, 0, 22]) cube([98.4, 3, 3]);
}
material("matte", color = [0.8, 0.78, 0.75]) {
    translate([-500, -500, -2]) cube([1000, 1000, 2]);
    translate([-500, 120, -2]) cube([1000, 2, 500]);
}

light(p = [105, -80, 115], r = 13, power = 6e5, color = [1, 0.84, 0.66]);
area_light(p = [-140, -100, 70], u = [40, -34, 0], v = [0, 0, 70], power = 4.5e5, color = [0.66, 0.8, 1]);
camera(eye = [-26, -170, 92], target = [-3, 6, 16], fov = 34);
