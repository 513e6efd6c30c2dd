// One cone a pixel: edges are smooth, the ball lamp's shadow is soft and the rough floor blurs what it mirrors, all without a random number.
// Render with --integrator cone --samples 1.
include <whittle.scad>

module die(c) material("plastic", color = c) difference() {
    roundcube([16, 16, 16], r = 2, center = true);
    for (p = [[0, 0, 9], [4, 4, 9], [-4, -4, 9]]) translate(p) sphere(2.4);
    for (p = [[4, -9, 4], [-4, -9, -4]]) translate(p) sphere(2.4);
}
translate([-16, 4, 8]) rotate([0, 0, 20]) die([0.8, 0.14, 0.1]);
translate([14, -10, 8]) rotate([0, 0, -32]) die([0.12, 0.34, 0.62]);
translate([4, 24, 0]) material("plastic", color = [0.85, 0.7, 0.25]) { cylinder(h = 22, r = 6); translate([0, 0, 22]) cylinder(h = 14, r1 = 6, r2 = 0); }
material("steel", color = [0.6, 0.62, 0.66], roughness = 0.2) translate([-300, -300, -2]) cube([600, 600, 2]);

light(p = [70, -60, 110], r = 12, power = 8e5);
environment(color = [0.35, 0.38, 0.45]);
camera(eye = [-20, -120, 80], target = [0, 4, 7], fov = 34);
