// A room with a coloured wall on either side and one lamp: what is white takes their colours. Paths of any length.
include <whittle.scad>

s = 60;
white = [0.76, 0.75, 0.7];
material("matte", color = white) {
    translate([-s, -s, -2]) cube([2 * s, 2 * s, 2]);
    translate([-s, s, 0]) cube([2 * s, 2, 2 * s]);
    translate([-s, -s, 2 * s]) cube([2 * s, 2 * s, 2]);
}
material("matte", color = [0.7, 0.12, 0.08]) translate([-s - 2, -s, 0]) cube([2, 2 * s, 2 * s]);
material("matte", color = [0.15, 0.5, 0.16]) translate([s, -s, 0]) cube([2, 2 * s, 2 * s]);

material("matte", color = white) translate([-22, 18, 0]) rotate([0, 0, 18]) difference() {
    translate([-17, -17, 0]) cube([34, 34, 72]);
    translate([0, -20, 50]) rotate([-90, 0, 0]) cylinder(h = 60, r = 10);
}
material("silver", roughness = 0.3) translate([26, -16, 18]) sphere(18);

area_light(p = [-16, -16, 2 * s - 0.1], u = [32, 0, 0], v = [0, 32, 0], power = 1.5e5, color = [1, 0.93, 0.8]);
environment(color = "black");
camera(eye = [0, -245, 60], target = [0, 0, 60], fov = 36);
