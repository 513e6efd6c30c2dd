// Cams, cranks, an escapement and a sprocket: 2D set work, projection, resize, mirror, intersection_for, hull chains, minkowski.
$fn = 20;
function bezier(p, t) = len(p) == 1 ? p[0] : bezier([for (i = [0 : len(p) - 2]) p[i] * (1 - t) + p[i + 1] * t], t);
function curve(p, n) = [for (i = [0 : n]) bezier(p, i / n)];
module chain(ps, r) for (i = [0 : len(ps) - 2]) hull() { translate(ps[i]) circle(r); translate(ps[i + 1]) circle(r * 0.8); }
module cam(lift) hull() { circle(10); translate([lift, 0]) circle(4); }
module escapement(teeth) difference() {
    union() { circle(15); for (i = [0 : teeth - 1]) rotate(i * 360 / teeth) polygon([[14, -2], [20, 3], [14, 3]]); }
    circle(3);
    for (i = [0 : 4]) rotate(i * 72) translate([9, 0]) scale([1, 0.6]) circle(3);
}
module sprocket(n, pitch = 8) { r = pitch / 2 / sin(180 / n); linear_extrude(3) difference() { circle(r + 2, $fn = 40); for (i = [1 : n]) rotate(360 * i / n) translate([r, 0]) circle(2.5); } }
linear_extrude(4) difference() { cam(12); circle(2); translate([12, 0]) circle(1.5); }
translate([50, 0, 0]) linear_extrude(height = 3, center = true) escapement(15);
translate([0, 40, 0]) sprocket(11);
translate([0, -40, 0]) linear_extrude(3, scale = [0.5, 1.5], slices = 4) chain(curve([[0, 0], [10, 20], [25, -20], [35, 5]], 8), 2);
translate([50, 40, 0]) intersection_for(a = [0 : 60 : 120]) rotate(a) cube([30, 18, 6], center = true);
translate([50, -40, 0]) linear_extrude(2) projection() rotate([30, 20, 0]) cube([12, 8, 6], center = true);
translate([80, -40, 0]) linear_extrude(2) projection(cut = true) rotate([30, 20, 0]) translate([0, 0, 1]) cube([12, 8, 6], center = true);
translate([90, 0, 0]) resize([20, 0, 10], auto = [false, true, false]) sphere(3);
translate([90, 40, 0]) minkowski() { cube([10, 6, 2]); cylinder(r = 2, h = 1); }
translate([120, 0, 0]) mirror([1, 1, 0]) rotate_extrude(angle = 210) translate([8, 0]) intersection() { square(6, center = true); circle(3.5); }
translate([120, 40, 0]) multmatrix([[1, 0.3, 0, 0], [0, 1, 0.2, 0], [0, 0, 1]]) render() difference() { cube(12); translate([6, 6, 6]) sphere(7); }
echo(curve([[0, 0], [1, 2], [3, 3]], 4), bezier([[0, 0, 1], [2, 2, 2]], 0.3));
