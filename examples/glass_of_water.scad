// A glass of water. Water and glass abut: on each ray the border from glass to water is one border, with no air between.
include <whittle.scad>

outer_r = 30;
wall = 2;
base = 6;
height = 90;
filled = 60;     // height of the water

material("glass") difference() {
    cylinder(h = height, r = outer_r);
    translate([0, 0, base]) cylinder(h = height - base, r = outer_r - wall);
}

material("water") translate([0, 0, base]) cylinder(h = filled, r = outer_r - wall);

// A straw; where it stands in the water, the higher priority says that there is straw.
material("plastic", color = "orange", priority = 1)
    translate([-14, 0, base + 15]) rotate([0, 20, 0]) cylinder(h = 90, r = 2.5);

color("whitesmoke") translate([0, 0, -2]) cylinder(h = 2, r = 70);  // the table

camera(eye = [0, -260, 130], target = [0, 0, 40], fov = 32);

// The straw leans in the plane y = 0 and leaves through the water's surface: what it adds is a cylinder cut at z = base + filled.
// fact: volume = 226971.272767; table + glass + water + the straw's length beyond the surface, pi r^2 (90 - 45 / cos 20)
// fact: genus = 0; nothing goes through
// fact: components = 1; the glass stands on the table
// perturb: filled = 61
