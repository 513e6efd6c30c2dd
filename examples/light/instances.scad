// One wheel, eleven times: turned, mirrored, sheared, squeezed. The solid is kept once; rays go into its frame, normals come back by the inverse transpose.
include <whittle.scad>

module gear() difference() {
    union() {
        cylinder(h = 6, r = 12);
        for (i = [0:11]) rotate([0, 0, i * 30]) translate([11, -1.6, 0]) cube([4, 3.2, 6]);
        translate([0, 0, 6]) cylinder(h = 3, r1 = 8, r2 = 5);
    }
    translate([0, 0, -1]) cylinder(h = 12, r = 3);
    for (i = [0:4]) rotate([0, 0, i * 72]) translate([7.6, 0, -1]) cylinder(h = 8, r = 1.7);
}

colors = ["tomato", "goldenrod", "teal", "slateblue"];
for (i = [0:10]) rotate([0, 0, i * 360 / 11]) translate([62, 0, 16]) color(colors[i % 4])
    multmatrix([[1, i % 3 == 1 ? 0.5 : 0, 0, 0], [0, i % 3 == 2 ? 0.55 : 1, 0, 0], [0, 0, i % 2 == 0 ? 1 : -1.6, 0]]) rotate([0, 62, i * 13]) gear();
material("brushed") scale([1.7, 1.7, 1]) gear();
material("matte", color = [0.9, 0.9, 0.9]) translate([-300, -300, -2]) cube([600, 600, 2]);
camera(eye = [0, -190, 150], target = [0, -4, 6], fov = 42);
