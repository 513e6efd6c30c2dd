// Light from a picture of the sky: its sun is found by drawing directions as bright as they are.
include <whittle.scad>

material("silver", roughness = 0.05) translate([-26, 0, 16]) sphere(16);
material("plastic", color = [0.85, 0.83, 0.8]) translate([8, 4, 0]) difference() {
    translate([-12, -12, 0]) cube([24, 24, 24]);
    translate([0, 0, 24]) sphere(13);
}
material("copper") translate([40, -6, 0]) rotate_extrude() translate([9, 4]) circle(4);
material("matte", color = [0.55, 0.52, 0.47]) translate([0, 0, -2]) cylinder(h = 2, r = 90);

environment("sky.hdr", rotate = 35);
camera(eye = [-20, -150, 62], target = [4, 0, 10], fov = 36);
