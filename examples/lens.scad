// A biconvex lens: what two balls share, held in a brass ring.
include <whittle.scad>

curvature = 40;   // radius of both faces
aperture = 15;    // radius of the lens
ring_wall = 3;
ring_height = 6;

sag = curvature - sqrt(curvature * curvature - aperture * aperture);

material("glass") intersection() {
    translate([0, 0, sag - curvature]) sphere(curvature);
    translate([0, 0, curvature - sag]) sphere(curvature);
}

// The rim of the lens is an edge of radius `aperture`; the ring begins a hair's breadth beyond.
color("goldenrod") difference() {
    cylinder(h = ring_height, r = aperture + ring_wall, center = true);
    cylinder(h = ring_height, r = aperture + 0.05, center = true);
}

camera(eye = [42, -58, 40], target = [0, 0, 0], fov = 26);

// fact: volume = 3927.15503534; two caps pi s^2 (R - s/3), and the ring pi ((a + w)^2 - (a + 0.05)^2) h
// fact: area = 3325.80374118; two caps 2 pi R s, and the ring's four faces
// fact: genus = 1; the ring's; the lens has none
// fact: components = 2; lens and ring
// perturb: aperture = 15.1
