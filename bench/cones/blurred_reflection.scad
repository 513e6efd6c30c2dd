// Matte blocks and balls mirrored in a floor of rough steel.
include <whittle.scad>

for (i = [-2:2]) material("matte", color = [0.5 + 0.2 * i, 0.6 - 0.1 * i, 0.5]) translate([i * 18, 4 * i, 0]) {
    translate([-5, -5, 0]) cube([10, 10, 14]);
    translate([0, 0, 19]) sphere(5);
}
material("steel", color = [0.7, 0.7, 0.72], roughness = 0.25) translate([-200, -200, -2]) cube([400, 400, 2]);
material("matte", color = [0.75, 0.7, 0.6]) translate([-200, 80, -2]) cube([400, 4, 120]);

light(p = [60, -90, 110], power = 9e5);
environment(color = "black");
camera(eye = [-20, -130, 60], target = [0, 6, 8], fov = 36);
