// A castle: four round towers, walls between their axes, a gate, and battlements cut flush.
side = 60;          // between the towers' axes
tower_r = 10;
tower_h = 36;
wall_t = 8;
wall_h = 24;
roof_h = 16;
gate_w = 12;
gate_h = 10;        // to the spring of the arch
merlon = 4;

module tower() {
    color("tan") cylinder(h = tower_h, r = tower_r);
    color("firebrick") translate([0, 0, tower_h]) cylinder(h = roof_h, r1 = tower_r + 2, r2 = 0);
}

// A wall along x; five gaps in its crown.
module curtain() difference() {
    translate([0, -wall_t / 2, 0]) cube([side, wall_t, wall_h]);
    for (i = [-2 : 2])
        translate([side / 2 + 2 * i * merlon - merlon / 2, -wall_t / 2, wall_h - merlon]) cube([merlon, wall_t, merlon]);
}

module gate() translate([side / 2, 0, 0]) {
    translate([-gate_w / 2, -wall_t / 2, 0]) cube([gate_w, wall_t, gate_h]);
    translate([0, 0, gate_h]) rotate([90, 0, 0]) cylinder(h = wall_t, d = gate_w, center = true);
}

for (i = [0 : 3]) rotate([0, 0, 90 * i]) translate([-side / 2, -side / 2, 0]) {
    tower();
    color("wheat") difference() {
        curtain();
        if (i == 0) gate();
    }
}

// A wall's end inside a tower: the half strip of a disc, R^2 asin(w/R) + w sqrt(R^2 - w^2), with w half the wall; each tower takes two, which
// overlap in a corner of a wall's half thickness squared.
// fact: volume = 82057.5577895; towers + roofs + walls beyond the towers - gaps - gate
// fact: genus = 1; the court; the gate is a notch from below
// fact: components = 1; walls and towers are one
// perturb: wall_t = 8.1
