// A glass ball and a ring of gold gather low sunlight: the ball to its focus and the bright fold of light around it, the inside of the ring to the
// heart-shaped curve of a coffee cup.
include <whittle.scad>

material("glass") translate([-24, 2, 15]) sphere(15);
material("gold", roughness = 0) translate([25, 2, 0]) difference() {
    cylinder(h = 13, r = 20);
    translate([0, 0, -1]) cylinder(h = 15, r = 18.6);
}
material("matte", color = [0.6, 0.52, 0.44]) translate([-400, -400, -2]) cube([800, 800, 2]);

sun(direction = [0.62, -0.55, -0.75], irradiance = 3, angle = 0.5, color = [1, 0.95, 0.86]);
environment("sky.hdr", intensity = 0.6, rotate = 150);
camera(eye = [8, -118, 84], target = [4, -4, 3], fov = 34);
// integrator: caustics
