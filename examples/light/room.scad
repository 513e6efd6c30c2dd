// A room with a coloured wall on either side and one lamp: what is white takes their colours. Paths of any length.
include <whittle.scad>

w = 82;     // half the width
d = 60;     // half the depth
h = 122;
white = [0.78, 0.77, 0.73];
material("matte", color = white) {
    translate([-w, -d, -2]) cube([2 * w, 2 * d, 2]);
    translate([-w, d, 0]) cube([2 * w, 2, h]);
    translate([-w, -d, h]) cube([2 * w, 2 * d, 2]);
}
material("matte", color = [0.72, 0.1, 0.06]) translate([-w - 2, -d, 0]) cube([2, 2 * d, h]);
material("matte", color = [0.1, 0.4, 0.16]) translate([w, -d, 0]) cube([2, 2 * d, h]);

// A block with three bores that meet: light comes out of all of them.
material("matte", color = white) translate([-34, 14, 0]) rotate([0, 0, 20]) difference() {
    translate([-20, -20, 0]) cube([40, 40, 76]);
    translate([0, 0, 50]) { rotate([-90, 0, 0]) cylinder(h = 60, r = 13, center = true); rotate([0, 90, 0]) cylinder(h = 60, r = 13, center = true); cylinder(h = 60, r = 13); }
}
material("copper", roughness = 0.45) translate([32, -8, 20]) sphere(20);

area_light(p = [-22, -20, h - 0.1], u = [44, 0, 0], v = [0, 36, 0], power = 3.4e5, color = [1, 0.93, 0.8]);
environment(color = "black");
camera(eye = [0, -250, 61], target = [0, 0, 61], fov = 35.5);
// Render with --integrator path.
