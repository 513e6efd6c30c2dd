// An angle bracket as one prints it: two plates, gussets of polygons, drilled and countersunk holes.
$fn = 100;
module hole(d, h) {
    translate([0, 0, -1]) cylinder(h = h + 2, d = d);
    translate([0, 0, h - 2]) cylinder(h = 2.01, d1 = d, d2 = 2 * d);
}
difference() {
    union() {
        translate([-30, 0, 0]) cube([60, 50, 6]);
        translate([-30, 0, 0]) cube([60, 6, 50]);
        for (x = [-30, -3, 24]) translate([x, 0, 0]) rotate([90, 0, 90]) linear_extrude(6) polygon([[6, 6], [36, 6], [6, 36]]);
    }
    for (x = [-15, 15], y = [20, 40]) translate([x, y, 0]) hole(5, 6);
    for (x = [-15, 15], z = [20, 40]) translate([x, 0, z]) rotate([-90, 0, 0]) hole(5, 6);
}
