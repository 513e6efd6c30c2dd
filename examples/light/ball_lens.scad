// A glass ball and a tilted ring of gold gather sunlight: the ball to its focus, 1.5 radii behind its middle, the ring's inside to the heart-shaped curve of
// a coffee cup.
include <whittle.scad>

material("glass") translate([-24, 4, 15]) sphere(15);
material("gold", roughness = 0) translate([26, 0, 0]) difference() {
    cylinder(h = 14, r = 20);
    translate([0, 0, -1]) cylinder(h = 16, r = 18.4);
}
material("matte", color = [0.86, 0.84, 0.8]) translate([-150, -150, -2]) cube([300, 300, 2]);

sun(direction = [0.55, -0.6, -0.85], irradiance = 3, angle = 0.5, color = [1, 0.97, 0.9]);
environment(color = [0.42, 0.5, 0.62]);
camera(eye = [-20, -150, 95], target = [4, 8, 4], fov = 36);
// integrator: caustics
