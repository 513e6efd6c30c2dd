// Hard shadows of a lamp without a size and of the sun: they begin exactly where a thing touches the ground, at any scale. Three stacks, each a tenth of the
// one before; nothing in it knows how large it is.
include <whittle.scad>

module still_life() {
    material("plastic", color = [0.78, 0.2, 0.1], roughness = 0.35) translate([-9, 0, 6]) sphere(6);
    material("plastic", color = [0.12, 0.34, 0.6], roughness = 0.35) difference() {
        translate([2, -5, 0]) cube([10, 10, 10]);
        translate([7, 0, 10]) sphere(4.5);
    }
    material("plastic", color = [0.88, 0.66, 0.16], roughness = 0.35) translate([7, 0, 8.6]) sphere(3.1);
    material("plastic", color = [0.2, 0.5, 0.3], roughness = 0.35) translate([0, 11, 0]) { cylinder(h = 2, r = 5); translate([0, 0, 2]) cylinder(h = 14, r1 = 4, r2 = 0); }
}
still_life();
translate([-5, -13.5, 0]) scale(0.3) still_life();
translate([-1.2, -18, 0]) scale(0.09) still_life();
material("matte", color = [0.84, 0.81, 0.75]) translate([-500, -500, -2]) cube([1000, 1000, 2]);

sun(direction = [0.75, 0.4, -0.62], irradiance = 3.4, color = [1, 0.93, 0.8]);
light(p = [28, -34, 30], power = 2.2e4, color = [0.6, 0.75, 1]);
environment(color = [0.44, 0.5, 0.6]);
camera(eye = [3, -44, 22], target = [-0.5, -5, 2.5], fov = 40);
