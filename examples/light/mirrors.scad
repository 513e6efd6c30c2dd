// Two mirrors face each other across a chessman: rows of images, each k times as far away and a little darker. Before it a corner of three mirrors, which
// shows everyone themselves.
include <whittle.scad>

module frame(w, h) difference() {
    cube([w + 8, 3, h + 8], center = true);
    cube([w, 4, h], center = true);
}

for (s = [-1, 1]) translate([0, s * 44, 34]) {
    material("mirror", color = [0.93, 0.95, 0.94]) cube([120, 2, 60], center = true);
    material("plastic", color = [0.3, 0.15, 0.07], roughness = 0.3) frame(120, 60);
}

// The chessman: one profile turned.
material("plastic", color = [0.75, 0.1, 0.08], roughness = 0.25) {
    rotate_extrude() polygon([[0, 0], [11, 0], [11, 3], [8, 5], [5, 8], [3.6, 18], [3.2, 26], [6, 27.5], [3.6, 29], [0, 29]]);
    translate([0, 0, 33]) sphere(5.6);
}

// The corner lies open to the camera.
translate([-42, 4, 0]) rotate([0, 0, -40]) material("mirror") difference() {
    cube(22);
    translate([1, -1, 1]) cube([30, 22, 30]);
}

// A chequered floor shows how often it is turned about.
for (x = [-7:6], y = [-7:6]) material("matte", color = (x + y) % 2 == 0 ? [0.72, 0.7, 0.66] : [0.2, 0.24, 0.3]) translate([x * 16, y * 16, -2]) cube([16, 16, 2]);

light(p = [-30, -12, 150], r = 12, power = 7e5);
environment(color = [0.42, 0.45, 0.52]);
camera(eye = [44, -40, 50], target = [-6, 34, 20], fov = 56);
