// A belt pulley: a drum with teeth, two flanges, a hub with a set screw, spokes left between holes, chamfers.
$fn = 100;
teeth = 40;
difference() {
    union() {
        cylinder(h = 16, d = 50);
        cylinder(h = 2, d1 = 56, d2 = 52);
        translate([0, 0, 14]) cylinder(h = 2, d1 = 52, d2 = 56);
        cylinder(h = 26, d = 20);
    }
    for (k = [0 : teeth - 1]) rotate(360 * k / teeth) translate([25, 0, 2]) cylinder(h = 12, d = 2.2, $fn = 24);
    for (k = [0 : 5]) rotate(60 * k) translate([16.5, 0, -1]) cylinder(h = 30, d = 9);
    translate([0, 0, -1]) cylinder(h = 40, d = 8);
    translate([0, 0, 25]) cylinder(h = 1.01, d1 = 8, d2 = 10);
    translate([0, 0, 21]) rotate([90, 0, 0]) cylinder(h = 20, d = 3, $fn = 32);
}
