// Two mirrors face each other across a chessman: rows of images, each k times as far away and a little darker. In front a corner of three mirrors, which
// shows everyone themselves.
include <whittle.scad>

module frame(w, h) difference() {
    cube([w + 8, 3, h + 8], center = true);
    cube([w, 4, h], center = true);
}

for (s = [-1, 1]) translate([0, s * 55, 34]) rotate([0, 0, s * 2]) {
    material("mirror", color = [0.9, 0.93, 0.92]) cube([110, 2, 60], center = true);
    material("plastic", color = [0.25, 0.14, 0.08]) frame(110, 60);
}

// The chessman: one profile turned.
material("plastic", color = [0.75, 0.12, 0.1], roughness = 0.25) rotate_extrude() polygon([[0, 0], [11, 0], [11, 3], [8, 5], [5, 8], [3.6, 18], [3.2, 26], [6, 27.5],
    [3.6, 29], [0, 29]]);
material("plastic", color = [0.75, 0.12, 0.1], roughness = 0.25) translate([0, 0, 33]) sphere(5.6);

// The corner stands on its tip, open to the camera.
translate([-34, 4, 12]) rotate([0, 0, -40]) material("mirror") difference() {
    translate([-13, -13, -13]) cube(14);
    translate([-12, -12, -12]) cube(40);
}

material("matte", color = [0.6, 0.6, 0.58]) translate([-200, -200, -2]) cube([400, 400, 2]);

light(p = [70, -20, 160], r = 14, power = 9e5);
environment(color = [0.3, 0.33, 0.4]);
camera(eye = [64, -47, 52], target = [-6, 26, 25], fov = 52);
