// A hex bolt and its nut. The hexagons are the author's six facets; everything round is round.
shank_d = 10;
shank_h = 34;
head_h = 6.4;
nut_h = 8;
key = 17;       // across the flats

module hexagon(h) cylinder(h = h, d = key / cos(30), $fn = 6);

// Corners turned off by 30 degrees: a cone that meets the flats' middle at the face.
module chamfered_hexagon(h) intersection() {
    hexagon(h);
    cylinder(h = h, r1 = key / 2 + h * sqrt(3), r2 = key / 2);
}

color("slategray") {
    chamfered_hexagon(head_h);
    translate([0, 0, -shank_h]) cylinder(h = shank_h, d = shank_d);
    translate([0, 0, -shank_h - 1.5]) cylinder(h = 1.5, d1 = shank_d - 3, d2 = shank_d);
}

color("darkkhaki") translate([24, 0, -shank_h - 1.5]) difference() {
    intersection() {
        chamfered_hexagon(nut_h);
        translate([0, 0, nut_h]) mirror([0, 0, 1]) chamfered_hexagon(nut_h);
    }
    cylinder(h = nut_h, d = shank_d + 0.4);
    cylinder(h = 1, d1 = shank_d + 2.4, d2 = shank_d + 0.4);
}

// Chamfer: the prism beyond the cone, integrated over the angle: 12 * integral over 0..30 degrees, inner radius k = key/2 to k/cos.
// fact: volume = 5647.433732 within 1e-9; prisms - three chamfers + shank + its tip - bore - the bore's chamfer
// fact: genus = 1; the nut
// fact: components = 2; bolt and nut
// perturb: key = 17.1
