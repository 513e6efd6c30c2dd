// A chain: rings in turn flat and upright, linked and nowhere touching.
include <whittle.scad>

links = 7;
ring_r = 8;
wire_r = 1.6;
pitch = 2 * ring_r - 2 * wire_r - 1;  // a gap of a millimetre at each link

material("gold")
    for (i = [0 : links - 1])
        translate([i * pitch, 0, 0]) rotate([i % 2 * 90, 0, 0]) torus(ring_r, wire_r);

camera(eye = [62, -88, 70], target = [(links - 1) * pitch / 2, 0, 0], fov = 36);

// fact: volume = 2829.81297388; 7 * 2 pi^2 R r^2
// fact: area = 3537.26621735; 7 * 4 pi^2 R r
// fact: genus = 7; a ring each
// fact: components = 7; linked, not joined
// perturb: wire_r = 1.62
