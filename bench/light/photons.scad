// A glass ball and a glass lens throw a lamp's light together on a floor.
include <whittle.scad>

material("glass") translate([-14, 0, 14]) sphere(12);
material("glass") translate([18, 0, 12]) rotate([50, 0, 60]) intersection() {
    translate([0, 0, 16]) sphere(20);
    translate([0, 0, -16]) sphere(20);
}
material("matte", color = [0.8, 0.75, 0.68]) translate([-150, -150, -2]) cube([300, 300, 2]);

light(p = [40, 50, 90], power = 7e5);
environment(color = "black");
camera(eye = [0, -120, 80], target = [0, -6, 4], fov = 36);
