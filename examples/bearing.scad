// A deep-groove ball bearing: the races are rings less a torus, the balls are balls.
include <whittle.scad>

bore = 10;        // radii and widths in millimetres
inner_land = 16;  // outer radius of the inner ring
outer_land = 20;  // inner radius of the outer ring
outside = 26;
width = 14;
pitch_r = 18;     // where the balls run
groove_r = 5;
play = 0.05;
balls = 9;

module ring(from, to) difference() {
    cylinder(h = width, r = to, center = true);
    cylinder(h = width, r = from, center = true);
}

module races() difference() {
    union() {
        ring(bore, inner_land);
        ring(outer_land, outside);
    }
    torus(pitch_r, groove_r);
}

color("lightsteelblue") races();
material("gold")
    for (i = [0 : balls - 1])
        rotate([0, 0, 360 * i / balls]) translate([pitch_r, 0, 0]) sphere(groove_r - play);

camera(eye = [52, -72, 112], target = [0, 0, -2], fov = 24);

// Groove: the part of the torus beyond a land e = 2 away from the pitch circle, by Pappus.
// fact: volume = 19090.3160678; rings - both grooves + nine balls
// fact: area = 12368.0743104; rings - the bands that the grooves open + the grooves' sheets + nine balls
// fact: genus = 2; two rings
// fact: components = 11; two rings, nine balls
// perturb: groove_r = 5.05
