// One wheel, twelve times: turned, mirrored, sheared, squeezed. The solid is kept once; rays go into its frame, normals come back by the inverse transpose.
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

colors = [[0.8, 0.16, 0.1], [0.85, 0.55, 0.08], [0.05, 0.42, 0.42], [0.22, 0.2, 0.55]];
for (i = [0:10]) rotate([0, 0, i * 360 / 11]) translate([58, 0, 16]) material("plastic", color = colors[i % 4], roughness = 0.3)
    multmatrix([[1, i % 3 == 1 ? 0.5 : 0, 0, 0], [0, i % 3 == 2 ? 0.55 : 1, 0, 0], [0, 0, i % 2 == 0 ? 1 : -1.6, 0]]) rotate([0, 62, i * 13]) gear();
material("gold", roughness = 0.35) scale([2, 2, 1.2]) gear();
material("matte", color = [0.5, 0.5, 0.52]) translate([-900, -900, -2]) cube([1800, 1800, 2]);

area_light(p = [-160, -120, 120], u = [90, -60, 0], v = [10, 20, 80], power = 1.6e6, color = [1, 0.96, 0.9]);
area_light(p = [-80, 60, 200], u = [160, 0, 0], v = [0, 90, 20], power = 1.2e6, color = [0.9, 0.95, 1]);
environment(color = [0.34, 0.37, 0.43]);
camera(eye = [0, -170, 118], target = [0, -4, 8], fov = 42);
