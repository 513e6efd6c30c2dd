function f($x, y = 2) = g() + y; function g() = $x; echo(f(3), f($x = 4, y = 1));
module m($r = 7) { n(); } module n() { echo($r); } m(); m(8);
echo(let ($k = 2) h()); function h() = $k;
