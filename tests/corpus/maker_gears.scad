// Involute gears, a rack, a planetary set. Everything is a function of the module.
m = 2;
alpha = 20;
backlash = 0.1;
function polar(r, a) = [r * cos(a), r * sin(a)];
function rad(x) = x * PI / 180;
function deg(x) = x * 180 / PI;
function inv(a) = tan(a) - rad(a);
function base(z) = m * z * cos(alpha) / 2;
function rotate2(p, a) = [[cos(a), -sin(a)], [sin(a), cos(a)]] * p;
function mirror_y(ps) = [for (i = [len(ps) - 1 : -1 : 0]) [ps[i].x, -ps[i].y]];
function involute(rb, t) = rb * [cos(deg(t)) + t * sin(deg(t)), sin(deg(t)) - t * cos(deg(t))];
function tooth(z, steps = 5, x = 0) =
    let (
        rb = base(z), rp = m * z / 2, ra = rp + m * (1 + x), rf = rp - 1.25 * m + m * x,
        tmax = sqrt(pow(ra / rb, 2) - 1), tmin = rf > rb ? sqrt(pow(rf / rb, 2) - 1) : 0,
        half = 90 / z + deg(inv(alpha)) - deg(backlash / rp) / 2,
        flank = [for (i = [0 : steps]) rotate2(involute(rb, tmin + (tmax - tmin) * i / steps), -half)]
    )
    concat(rf < rb ? [polar(rf, -half)] : [], flank, mirror_y(flank), rf < rb ? [polar(rf, half)] : []);
function gear_points(z, x = 0) = [for (k = [0 : z - 1]) for (p = tooth(z, 5, x)) rotate2(p, 360 * k / z)];
function sum(v, i = 0, s = 0) = i == len(v) ? s : sum(v, i + 1, s + v[i]);
function shoelace(p) = sum([for (i = [0 : len(p) - 1]) let (q = p[(i + 1) % len(p)]) p[i].x * q.y - q.x * p[i].y]) / 2;

module gear(z, h, bore = 0, spokes = 0, helix = 0) {
    linear_extrude(height = h, twist = helix, slices = helix == 0 ? 1 : 6, convexity = 10) difference() {
        polygon(gear_points(z));
        if (bore > 0) circle(d = bore, $fn = 24);
        if (spokes > 0) {
            inner = bore / 2 + m * 2;
            outer = m * z / 2 - 3 * m;
            if (outer > inner) for (i = [0 : spokes - 1]) rotate(i * 360 / spokes) slot(inner, outer, 360 / spokes - 20);
            else echo("no room for spokes", z = z);
        }
    }
}
module slot(ri, ro, a) {
    n = max(2, ceil(a / 10));
    polygon(concat([for (i = [0 : n]) polar(ri, a * (i / n - 0.5))], [for (i = [n : -1 : 0]) polar(ro, a * (i / n - 0.5))]));
}
module ring(z, h, rim) {
    linear_extrude(height = h, convexity = 8) difference() {
        circle(r = m * z / 2 + rim, $fn = 72);
        polygon(gear_points(z, 0.25));
    }
}
module rack(teeth, h) {
    p = m * PI;
    w = p / 2 - 2 * m * tan(alpha);
    linear_extrude(h) union() {
        translate([0, -3 * m]) square([teeth * p, 2 * m]);
        for (i = [0 : teeth - 1]) translate([i * p, 0])
            polygon([[w / 2, m], [p - w / 2 - p / 2, m], [p - w / 2 - p / 2 + 2.25 * m * tan(alpha), -1.25 * m], [w / 2 - 2.25 * m * tan(alpha), -1.25 * m]]);
    }
}
module planetary(sun, planet, count = 3) {
    outer = sun + 2 * planet;
    if ((sun + outer) % count != 0) echo(str("WRONG: ", sun, " + ", outer, " is no multiple of ", count));
    gear(sun, 6, bore = 5);
    for (k = [0 : count - 1]) {
        a = 360 * k / count;
        rotate(a) translate([m * (sun + planet) / 2, 0, 0]) rotate(a * sun / planet + (planet % 2 == 0 ? 180 / planet : 0)) gear(planet, 6, bore = 4);
    }
    ring(outer, 6, 5);
}
echo(area = shoelace(gear_points(17)), tooth = tooth(17)[0], count = len(tooth(17)), tooth(60)[0]);
for (z = [8, 17, 40]) echo(z, base(z), inv(alpha), [for (p = tooth(z, 2)) round(norm(p) * 1000) / 1000]);
gear(24, 5, bore = 6, spokes = 5);
translate([60, 0, 0]) gear(12, 8, bore = 4, spokes = 3, helix = 30);
translate([0, -50, 0]) rack(6, 5);
translate([0, 90, 0]) planetary(12, 15, 3);
translate([120, 90, 0]) planetary(10, 11);
