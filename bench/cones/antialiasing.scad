// Edges of boxes, balls and holes, and a fan of blades thinner than a pixel in the distance: one lamp without a size.
include <whittle.scad>

module block(c) material("matte", color = c) difference() {
    cube([20, 20, 16], center = true);
    sphere(10.5);
    rotate([90, 0, 0]) cylinder(h = 40, r = 4, center = true);
}
translate([-16, -10, 8]) rotate([0, 0, 25]) block([0.8, 0.3, 0.2]);
translate([14, -14, 8]) rotate([0, 0, -38]) block([0.3, 0.5, 0.8]);
for (i = [0:14]) material("matte", color = [0.9, 0.8, 0.3]) translate([0, 34, 0]) rotate([0, 0, 12 * i]) cube([26, 0.4, 12 + i]);
material("matte", color = [0.7, 0.68, 0.65]) translate([-150, -150, -2]) cube([300, 300, 2]);

light(p = [70, -60, 110], power = 8e5);
environment(color = "black");
camera(eye = [-20, -120, 80], target = [0, 4, 7], fov = 34);
