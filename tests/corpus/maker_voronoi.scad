// A vase with a skin of cells: seeds from rands, cells by half-plane clipping, wrapped round a profile.
seed = 11;
cells = 14;
height = 60;
size = [120, height];
pts = let (xs = rands(0, size.x, cells, seed), ys = rands(0, size.y, cells, seed + 1)) [for (i = [0 : cells - 1]) [xs[i], ys[i]]];
function side(p, a, n) = (p - a) * n;
function cut(p, q, a, n) = let (u = side(p, a, n), v = side(q, a, n)) p + (q - p) * u / (u - v);
function clip(poly, a, n) = [
    for (i = [0 : 1 : len(poly) - 1])
        let (p = poly[i], q = poly[(i + 1) % len(poly)], pin = side(p, a, n) <= 0, qin = side(q, a, n) <= 0)
        each pin ? (qin ? [q] : [cut(p, q, a, n)]) : (qin ? [cut(p, q, a, n), q] : [])
];
function clip_all(poly, c, others, i = 0) = i == len(others) ? poly
    : clip_all(others[i] == c ? poly : clip(poly, (c + others[i]) / 2, others[i] - c), c, others, i + 1);
function wrapped(ps) = concat(ps, [for (p = ps) p + [size.x, 0]], [for (p = ps) p - [size.x, 0]]);
function cell(c) = clip_all([[c.x - size.x, 0], [c.x + size.x, 0], [c.x + size.x, size.y], [c.x - size.x, size.y]], c, wrapped(pts));
function mean(v) = [for (i = [0 : 1 : len(v) - 1]) 1] * v / len(v);
function shrink(poly, f) = let (c = mean(poly)) [for (p = poly) c + (p - c) * f];
function area(p) = abs([for (i = [0 : 1 : len(p) - 1]) cross(p[i], p[(i + 1) % len(p)])] * [for (q = p) 1]) / 2;
function quicksort(v) = len(v) <= 1 ? v : let (p = v[floor(len(v) / 2)]) concat(quicksort([for (x = v) if (x < p) x]), [for (x = v) if (x == p) x], quicksort([for (x = v) if (x > p) x]));
all = [for (p = pts) cell(p)];
echo(areas = quicksort([for (c = all) round(area(c))]), total = [for (c = all) area(c)] * [for (c = all) 1], full = size.x * size.y);
echo([for (c = all) len(c)], min([for (c = all) len(c)]), max([for (c = all) len(c)]));
profile = [for (z = [0 : 6 : height]) [18 + 5 * sin(z * 6), z]];
module body(t) rotate_extrude($fn = 40) polygon(concat([[0, 0]], [for (p = profile) p + [t, 0]], [[0, height]]));
module window(c) {
    a = mean(c).x / size.x * 360;
    r = lookup(mean(c).y, [for (p = profile) [p.y, p.x]]);
    rotate(a) translate([r - 6, 0, 0]) rotate([90, 0, 90]) linear_extrude(height = 12, scale = 1.2) translate([-mean(c).x * 0, 0]) polygon([for (p = shrink(c, 0.72)) [p.x - mean(c).x, p.y]]);
}
difference() {
    body(0);
    translate([0, 0, 2]) body(-2);
    for (c = all) if (area(c) > 60) window(c);
}
