// What a picture of pixels cannot hold: a zone plate, whose rings become finer than any pixel, and chequers that run to the horizon. The filter (--filter)
// turns both to an even grey instead of false rings.
include <whittle.scad>

// The k-th ring ends at a radius of sqrt(k): all have one area.
material("matte", color = [0.94, 0.94, 0.92]) translate([-62, 0, 2]) cube([124, 2, 124]);
material("matte", color = [0.03, 0.03, 0.05]) translate([0, 0.5, 64]) rotate([90, 0, 0])
    for (k = [0 : 2 : 120]) difference() {
        cylinder(h = 1, r = 5.5 * sqrt(k + 1));
        if (k > 0) translate([0, 0, -1]) cylinder(h = 3, r = 5.5 * sqrt(k));
    }
for (x = [-40:40], y = [-4:90]) if ((x + y) % 2 == 0) material("matte", color = [0.08, 0.16, 0.3]) translate([x * 30, y * 30, -1]) cube([30, 30, 1]);
material("matte", color = [0.9, 0.88, 0.82]) translate([-1e4, -1e4, -3]) cube([2e4, 2e4, 2.5]);

light(p = [-160, -260, 300], power = 7e6);
environment(color = [0.62, 0.72, 0.86]);
camera(eye = [70, -260, 95], target = [14, 40, 48], fov = 40);
