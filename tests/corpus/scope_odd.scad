x = 1;
module a() { x = x + 1; echo(x); children(); y = x * 2; echo(y); }
a() { x = x + 10; echo("child", x); b(x) echo(x); }
module b(x, y = x) { echo(x, y); z = y; children(); module inner() { echo("inner", x, z); } inner(); function f(q) = q + x; echo(f(1)); }
b(5) echo("grandchild", x);
for (x = [x : x + 2]) { y = x; echo(x, y); for (x = [y]) echo(x); }
if (x == 1) { x = 7; echo(x); if (true) { x = x + 1; echo(x); } } else { echo("no"); }
let (x = 3, y = x) { echo(x, y); let (x = x + 1) echo(x, y); }
{ q = 4; echo(q); }
echo(q);
function g(x) = let (x = x + 1, x = x * 2) x;
echo(g(1));
v = [for (i = [0 : 2]) let (i = i * 2) for (i = [i, i + 1]) i];
echo(v);
$z = 3;
module d() { echo($z); $z = $z + 1; echo($z); e(); children(); }
module e() { echo("e", $z); }
d($z = 8) e();
d() { $z = 50; e(); }
e();
function h() = $z;
k = function() $z;
echo(h(), h($z = 9), let ($z = 10) h(), k(), let ($z = 11) k(), [for ($z = [1, 2]) k()]);
for ($z = [1 : 2]) e();
module m(x = $z) { echo(x); }
m(); m($z = 77); 
module n($w = 5) { echo($w); o(); } module o() { echo($w); }
n(); n(6); n($w = 7); o();
echo(x = 3, x, y = x);
assign(x = 5, w = x) echo(x, w);
u = let (a = 1, b = a, a = 2) [a, b]; echo(u);
