// Posts and balls under a rectangular lamp.
include <whittle.scad>

for (i = [0:6]) material("matte", color = [0.3 + 0.1 * i, 0.6, 0.8 - 0.1 * i]) translate([i * 16 - 48, 0, 0]) {
    cylinder(h = 8 + 4 * i, r = 2);
    translate([0, 0, 10 + 4 * i]) sphere(5);
}
material("matte", color = [0.8, 0.78, 0.75]) translate([-200, -200, -2]) cube([400, 400, 2]);

area_light(p = [-60, -90, 90], u = [40, 0, 0], v = [0, 30, 20], power = 9e5);
environment(color = "black");
camera(eye = [-10, -150, 80], target = [0, 6, 12], fov = 36);
