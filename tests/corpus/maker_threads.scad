// Screw threads as swept polyhedra, nuts and bolts with chamfers, thread tables.
/* [Bolt] */
// nominal diameter
size = "M8"; // [M3, M4, M5, M6, M8, M10, M12]
// length under the head
shank = 20; // [5:1:80]
/* [Quality] */
steps = 12; // [8, 12, 24, 48]
clearance = 0.2; // [0:0.05:0.6]
/* [Hidden] */
eps = 1 / 128;
table = [["M3", 0.5, 5.5], ["M4", 0.7, 7], ["M5", 0.8, 8], ["M6", 1, 10], ["M8", 1.25, 13], ["M10", 1.5, 16], ["M12", 1.75, 18]];

function row(name) = let(i = search([name], table)[0]) assert(is_num(i), str("no such thread: ", name)) table[i];
function pitch(name) = row(name)[1];
function flats(name) = row(name)[2];
function digits(s, i = 1, acc = 0) = i >= len(s) ? acc : digits(s, i + 1, acc * 10 + ord(s[i]) - ord("0"));
function diameter(name) = digits(name);
function depth(p) = p * sqrt(3) / 2 * 5 / 8;

// Points of one turn: four a step, inner and outer, lower and upper.
function helix_points(d, p, turns, n) = [
    for (i = [0 : turns * n])
        let (a = 360 * i / n, z = p * i / n, grow = min(1, i / n, (turns * n - i) / n), r = d / 2, h = depth(p) * grow)
        each [
            [(r - depth(p) - eps) * cos(a), (r - depth(p) - eps) * sin(a), z - p * 7 / 16],
            [(r - depth(p) + h) * cos(a), (r - depth(p) + h) * sin(a), z - p / 16],
            [(r - depth(p) + h) * cos(a), (r - depth(p) + h) * sin(a), z + p / 16],
            [(r - depth(p) - eps) * cos(a), (r - depth(p) - eps) * sin(a), z + p * 7 / 16],
        ]
];
function helix_faces(count) = concat(
    [[0, 1, 2, 3]],
    [for (i = [0 : count - 2], k = [0 : 3]) let(a = 4 * i + k, b = 4 * i + (k + 1) % 4) each [[a, a + 4, b + 4], [a, b + 4, b]]],
    [[for (k = [3 : -1 : 0]) 4 * (count - 1) + k]]
);
module thread(d, p, length, n = steps) {
    turns = floor(length / p);
    points = helix_points(d, p, turns, n);
    count = turns * n + 1;
    echo(turns = turns, points = len(points), faces = len(helix_faces(count)));
    polyhedron(points, helix_faces(count), convexity = 2 * turns);
}
module hexagon(af, h) { cylinder(d = af / cos(30), h = h, $fn = 6); }
module chamfered(af, h, both = true) {
    intersection() {
        hexagon(af, h);
        union() {
            top = af / 2 * (1 / cos(30) - 1) * tan(30);
            cylinder(r1 = both ? af / 2 : af, r2 = af / 2 + h * 1.7, h = h, $fn = 48);
            *cylinder(r = top, h = h);
        }
    }
}
module bolt(name, length) {
    d = diameter(name);
    p = pitch(name);
    chamfered(flats(name), d * 0.7);
    translate([0, 0, d * 0.7 - eps]) cylinder(d = d - 2 * depth(p), h = length, $fn = steps);
    translate([0, 0, d * 0.7 + p]) children();
    echo(str(name, "x", length, ": depth ", depth(p), " mm, lead ", atan(p / (PI * d)), " degrees"));
}
module nut(name, h = undef, gap = clearance) {
    hh = is_undef(h) ? diameter(name) * 0.8 : h;
    difference() {
        chamfered(flats(name), hh, false);
        translate([0, 0, -1]) cylinder(d = diameter(name) + 2 * gap, h = hh + 2, $fn = steps);
    }
}
bolt(size, shank) cylinder(d = diameter(size), h = shank - pitch(size) * 2, $fn = steps);
translate([30, 0, 0]) nut(size);
for (i = [0 : len(table) - 1]) translate([i * 22 - 50, 30, 0]) nut(table[i][0], h = 3 + i % 3);
translate([0, -40, 0]) thread(16, 4, 14, 10);
