// Faces that coincide. A preview by depth buffer flickers here; these borders are decided once, by name, so nothing flickers at any zoom.
a = 10;

// A pocket cut flush with the top: open, although the cutter ends exactly in the face.
color("tomato") difference() {
    cube(a);
    translate([a / 4, a / 4, a / 2]) cube([a / 2, a / 2, a / 2]);
}

// Two blocks that overlap with flush sides: one body, with no wall inside. Where both claim a face, the first written gives the colour.
translate([1.5 * a, 0, 0]) {
    color("seagreen") cube(a);
    color("gold") translate([a / 2, 0, 0]) cube([a, a, a / 2]);
}

// A ball's equal, taken from a slab: the bowl's rim lies in the face. And a rod that ends in both faces of it.
translate([0, -1.6 * a, 0]) {
    color("royalblue") difference() {
        cube([a, a, a / 2]);
        translate([a / 2, a / 2, a / 2]) sphere(0.4 * a);
    }
    color("white") translate([a / 2, a / 2, 0]) cylinder(h = a / 2, r = a / 10);
}

// A tube slid over a rod of its own bore, cut by a plane through the axis: three surfaces in one line.
translate([2.25 * a, -1.1 * a, 0]) difference() {
    union() {
        color("orchid") difference() {
            cylinder(h = a, r = a / 2);
            cylinder(h = a, r = a / 4);
        }
        color("khaki") cylinder(h = a, r = a / 4);
    }
    translate([-a, -a, a / 2]) cube([2 * a, a, a / 2]);
}

// fact: volume = 3092.37526227; 7/8 a^3 + 5/4 a^3 + (a^3/2 - 2/3 pi (0.4 a)^3 + the rod in the bowl) + 3/4 of a cylinder
// fact: genus = 0; no hole goes through
// fact: components = 4; four bodies that stand apart
// perturb: a = 10.02
