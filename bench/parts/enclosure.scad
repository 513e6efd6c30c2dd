// A box for electronics: walls between two rounded prisms, screw bosses, slots, round and hexagonal openings.
$fn = 100;
module rounded(x, y, h, r) {
    linear_extrude(h) hull() for (i = [-1, 1], j = [-1, 1]) translate([i * (x / 2 - r), j * (y / 2 - r)]) circle(r);
}
difference() {
    union() {
        difference() {
            rounded(80, 50, 30, 6);
            translate([0, 0, 2]) rounded(76, 46, 30, 4);
        }
        for (i = [-1, 1], j = [-1, 1]) translate([i * 32, j * 17, 0]) cylinder(h = 26, d = 8);
    }
    for (i = [-1, 1], j = [-1, 1]) translate([i * 32, j * 17, 0]) {
        translate([0, 0, 6]) cylinder(h = 30, d = 3);
        translate([0, 0, -1]) cylinder(h = 4, d = 6, $fn = 6);
    }
    for (k = [-5 : 5]) translate([4 * k - 1, -30, 12]) cube([2, 10, 12]);
    translate([0, 20, 15]) rotate([-90, 0, 0]) cylinder(h = 10, d = 12);
    translate([20, 20, 15]) rotate([-90, 0, 0]) cylinder(h = 10, d = 8, $fn = 6);
}
