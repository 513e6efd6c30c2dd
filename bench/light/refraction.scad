// A glass ball, a lens cut of two balls and a glass block before chequers, one lamp without a size.
include <whittle.scad>

material("glass") translate([-26, -4, 12]) sphere(12);
material("glass") translate([4, -10, 13]) rotate([90, 0, 0]) intersection() {
    translate([0, 0, 16]) sphere(20);
    translate([0, 0, -16]) sphere(20);
}
material("glass") translate([22, -12, 0]) rotate([0, 0, 25]) cube([16, 16, 22]);
for (x = [-5:4], y = [-5:4]) material("matte", color = (x + y) % 2 == 0 ? [0.85, 0.8, 0.7] : [0.15, 0.25, 0.4]) translate([x * 18, y * 18, -2]) cube([18, 18, 2]);

light(p = [50, -80, 110], power = 9e5);
environment(color = [0.35, 0.4, 0.5]);
camera(eye = [10, -130, 62], target = [0, 6, 8], fov = 34);
