// Parts that know their anchors: function literals as geometry, $-variables as the current part, attach() of children.
TOP = [0, 0, 1]; BOTTOM = -TOP; LEFT = [-1, 0, 0]; RIGHT = -LEFT; FRONT = [0, -1, 0]; BACK = -FRONT; CENTER = [0, 0, 0];
$part = undef;
function fold(op, v, start, i = 0) = i == len(v) ? start : fold(op, v, op(start, v[i]), i + 1);
function compose(outer, inner) = function(x) let (y = inner(x)) outer(y);
map = function(f, v) [for (x = v) f(x)];
filter = function(f, v) [for (x = v) if (f(x)) x];
curry = function(f) function(a) function(b) f(a, b);
add = function(a, b) a + b;
function part(kind, size, f) = [kind, size, f];
function box_part(size) = part("box", size, function(a) [for (i = [0 : 2]) a[i] * size[i] / 2]);
function tube_part(r, h) = part("tube", [2 * r, 2 * r, h], function(a) let (xy = [a.x, a.y], n = norm(xy)) concat(n == 0 ? [0, 0] : xy * r / n, [a.z * h / 2]));
function anchor_of(p, a) = let (f = p[2]) f(a);
function unit(v) = norm(v) == 0 ? v : v / norm(v);
function rot_to(d) = let (u = unit(d)) [0, acos(u.z), atan2(u.y, u.x)];
function describe(p) = str(p[0], p[1], is_function(p[2]) ? " with anchors" : "");
module show_part(p, a) {
    $part = p;
    $depth = is_undef($depth) ? 0 : $depth + 1;
    translate(-anchor_of(p, a)) {
        if (p[0] == "box") cube(p[1], center = true);
        else if (p[0] == "tube") cylinder(d = p[1].x, h = p[1].z, center = true, $fn = 32);
        children();
    }
}
module block(size, anchor = CENTER) show_part(box_part(is_num(size) ? [size, size, size] : size), anchor) children();
module tube(r, h, anchor = CENTER) show_part(tube_part(r, h), anchor) children();
module attach(where) {
    assert(!is_undef($part), "attach() stands inside a part");
    echo(str(parent_module(1), " at depth ", $depth, ": ", describe($part)), where, $parent_modules);
    for (w = is_list(where[0]) ? where : [where]) translate(anchor_of($part, w)) rotate(rot_to(w)) children();
}
module position(where) translate(anchor_of($part, where)) children();
module tree(n) if (n > 0) block([n * 3, n * 3, n * 5], BOTTOM) { attach(TOP) tree(n - 1); if (n > 1) attach([LEFT, RIGHT]) tree(n - 2); }
block([30, 20, 10]) {
    attach(TOP) tube(4, 12, BOTTOM) attach([RIGHT, LEFT]) block([3, 3, 6], BOTTOM);
    attach([FRONT, BACK]) tube(2, 5, BOTTOM);
    position([1, 1, 1]) block(4);
}
translate([60, 0, 0]) tree(4);
echo(fold(add, [1, 2, 3, 4], 0), fold(function(a, b) max(a, b), [3, 9, 2], -1 / 0), map(compose(function(x) x * x, function(x) x + 1), [0 : 4]));
echo(filter(function(x) x % 2 == 1, [for (i = [0 : 9]) i]), curry(add)(3)(4), (function(x, y = 7) [x, y])(1), add, curry);
echo(map(function(p) describe(p), [box_part([1, 2, 3]), tube_part(2, 5)]), anchor_of(tube_part(3, 4), [1, 1, 1]), add == add, add == curry, is_function(describe));
