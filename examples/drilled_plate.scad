// A mounting plate: a grid of counterbored holes and a slot. Every cutter ends flush with the face it opens.
length = 80;
width = 50;
thickness = 8;
hole_d = 5;
head_d = 9;
head_depth = 3.5;
columns = 5;
rows = 3;
pitch = 15;

module counterbored_hole() {
    cylinder(h = thickness, d = hole_d);
    translate([0, 0, thickness - head_depth]) cylinder(h = head_depth, d = head_d);
}

color("lightsteelblue") difference() {
    translate([-length / 2, -width / 2, 0]) cube([length, width, thickness]);
    for (i = [0 : columns - 1], j = [0 : rows - 1])
        if (!(i == 2 && j == 1))
            translate([(i - (columns - 1) / 2) * pitch, (j - (rows - 1) / 2) * pitch, 0]) counterbored_hole();
    linear_extrude(thickness) {  // the slot in the middle
        square([12, 6], center = true);
        translate([6, 0]) circle(3);
        translate([-6, 0]) circle(3);
    }
}

// fact: volume = 26843.5579111; l w t - 14 pi (d^2 (t - k) + D^2 k)/4 - (12*6 + 9 pi) t
// fact: area = 12047.5131113; box + 14 (pi d (t - k) + pi D k - pi d^2/2) - the slot's two mouths + its wall (24 + 6 pi) t
// fact: genus = 15; fourteen holes and the slot
// fact: components = 1; one skin
// perturb: head_depth = 3.6
