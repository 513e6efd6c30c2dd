// Posts, balls and a pierced plate under a ball lamp.
include <whittle.scad>

for (i = [0:5]) material("matte", color = [0.3 + 0.1 * i, 0.6, 0.8 - 0.1 * i]) translate([i * 15 - 38, -12, 0]) {
    cylinder(h = 6 + 4 * i, r = 2);
    translate([0, 0, 9 + 4 * i]) sphere(4);
}
material("matte", color = [0.8, 0.5, 0.3]) translate([0, 24, 16]) difference() {
    cube([60, 24, 2], center = true);
    for (x = [-20, 0, 20]) translate([x, 0, 0]) cylinder(h = 8, r = 6, center = true);
}
material("matte", color = [0.8, 0.78, 0.75]) translate([-200, -200, -2]) cube([400, 400, 2]);

light(p = [-60, -70, 110], r = 14, power = 8e5);
environment(color = "black");
camera(eye = [-10, -130, 80], target = [0, 6, 8], fov = 36);
