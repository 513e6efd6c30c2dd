// A bottle with the thread for its cap: true cylinders and a cone, and a helix swept here as a polyhedron.
body_r = 22;
body_h = 60;
neck_r = 11;
neck_h = 20;
shoulder_h = 14;
wall = 2;
pitch = 4;
turns = 2.5;
crest = 1.6;      // height of the thread over the neck
steps = 36;       // a turn

neck_z = body_h + shoulder_h;

// The thread's section at angle a: a trapezoid, its foot inside the neck's wall; it dies away at both ends.
function section(a) =
    let(rise = a / 360 * pitch, fade = min(1, a / 45, (turns * 360 - a) / 45), r = neck_r - 0.2 + (crest + 0.2) * fade)
    [for (p = [[neck_r - 0.6, -1.2], [r, -0.4], [r, 0.4], [neck_r - 0.6, 1.2]])
        [p[0] * cos(a), p[0] * sin(a), p[1] + rise]];

module thread() {
    n = turns * steps;
    points = [for (i = [0 : n]) each section(360 * i / steps)];
    sides = [for (i = [0 : n - 1], k = [0 : 3])
        let(a = 4 * i + k, b = 4 * i + (k + 1) % 4) each [[a, b, a + 4], [b, b + 4, a + 4]]];
    polyhedron(points, concat([[3, 2, 1, 0]], sides, [[4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 3]]), convexity = 6);
}

module shape(inset) {
    translate([0, 0, inset]) cylinder(h = body_h - inset, r = body_r - inset);
    translate([0, 0, body_h]) cylinder(h = shoulder_h, r1 = body_r - inset, r2 = neck_r - inset);
    translate([0, 0, neck_z]) cylinder(h = neck_h, r = neck_r - inset);
}

color("mediumseagreen") difference() {
    union() {
        shape(0);
        translate([0, 0, neck_z + 5]) thread();
    }
    shape(wall);
}

// fact: volume = 23956.4971096 within 1e-5; shell in closed form, the thread beyond the neck by quadrature of its sections
// fact: genus = 0; a vessel is a bent plate
// fact: components = 1; one skin
// perturb: wall = 2.05
