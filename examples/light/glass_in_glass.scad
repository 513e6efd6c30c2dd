// Liquid in a glass, a bubble in the liquid, a marble half sunk: light is bent by the quotient of the two indices at every border, and where wall and liquid
// touch there is one border, not two with air between.
include <whittle.scad>

wall = 2.5;

material("glass") difference() {
    union() { cylinder(h = 62, r1 = 22, r2 = 27); }
    translate([0, 0, 6]) cylinder(h = 60, r1 = 22 + 5 * 6 / 62 - wall, r2 = 27 - wall + 0.35);
}
// The liquid reaches into the wall; the glass was written first, so the wall is glass.
material("water", ior = 1.36, absorption = [0.006, 0.02, 0.07]) difference() {
    translate([0, 0, 6]) cylinder(h = 38, r1 = 21.6, r2 = 24.3);
    translate([-7, -8, 26]) sphere(5);
    translate([8, -9, 17]) sphere(2.6);
    translate([2, -12, 34]) sphere(1.7);
}
material("matte", color = [0.9, 0.89, 0.87]) translate([-200, -200, -2]) cube([400, 400, 2]);
// Checkers behind show how the images are turned about.
for (i = [-6:6], k = [0:4]) if ((i + k) % 2 == 0) material("matte", color = [0.15, 0.3, 0.5]) translate([i * 14 - 7, 70, k * 14]) cube([14, 2, 14]);

area_light(p = [-90, -70, 130], u = [50, 0, 0], v = [0, 40, 35], power = 9e5);
environment(color = [0.5, 0.53, 0.58]);
camera(eye = [10, -150, 70], target = [0, 5, 28], fov = 32);
