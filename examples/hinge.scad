// A butt hinge: two leaves with knuckles that fit between each other, and a pin with clearance.
leaf = [30, 60, 3];
knuckle_r = 4;
pin_r = 2;
clearance = 0.2;
knuckles = 5;
screw_d = 4;

pitch = leaf.y / knuckles;

module hinge_leaf(first) difference() {
    union() {
        translate([knuckle_r + clearance, 0, -knuckle_r]) cube([leaf.x - knuckle_r, leaf.y, leaf.z]);
        for (i = [first : 2 : knuckles - 1]) translate([0, i * pitch + clearance / 2, 0]) {
            rotate([-90, 0, 0]) cylinder(h = pitch - clearance, r = knuckle_r);
            translate([0, 0, -knuckle_r]) cube([knuckle_r + clearance, pitch - clearance, leaf.z]);
        }
    }
    rotate([-90, 0, 0]) cylinder(h = leaf.y, r = pin_r + clearance / 2);
    for (y = [12, 30, 48]) translate([20, y, -knuckle_r]) {
        cylinder(h = leaf.z, d = screw_d);
        translate([0, 0, leaf.z - 2]) cylinder(h = 2, d1 = screw_d, d2 = 2 * screw_d);  // countersink
    }
}

color("silver") hinge_leaf(0);
color("darkgoldenrod") translate([0, leaf.y, 0]) rotate([0, 0, 180]) hinge_leaf(1);
color("dimgray") rotate([-90, 0, 0]) cylinder(h = leaf.y, r = pin_r);

// Knuckle and its foot overlap where |z + 4| < 3 under the circle: a half segment.
// fact: volume = 12070.4803313; plates + feet + knuckles - their overlap - bores - countersinks + pin
// fact: genus = 11; six screw holes and five knuckle bores
// fact: components = 3; two leaves and the pin
// perturb: screw_d = 4.1
