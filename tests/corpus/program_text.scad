function f(x, y = 2) = x + y;
module m(a, b = [1, 2]) { t = a; translate([a, 0]) { cube(t); sphere(1, $fn = 5); } children(); module inner() cube(); function g() = 1; if (a > 1) cube(); else { sphere(); cube(2); } for (i = [0:2]) cube(i); }
*cube(9);
z = f(1);
difference() { cube(); sphere(); }
{ w = 3; cube(w); }
let (q = 1) cube(q);
echo("a", b = 1);
union();
m(1) { k = 2; cube(k); }
if (z) cube(1); else { sphere(2); cube(3); }
v = [for (i = [0:3], j = [1, 2]) if (i > j) i else let (k = i) k, each [1, 2], for (a = 0; a < 3; a = a + 1) a];
w2 = let (a = 1) assert(a > 0, "m") echo(a) (function(x, y = 2) x * y)(3)[0].x;
s = "quote \" back \\ line \n tab \t";
t2 = z ? -z : !z; u = [1:2:9]; q = v[1]; r = z ^ 2 % 3;
