module m(a) echo(a); m(1, 2); m(1, 2, 3); m(zz = 1); m(1, zz = 2, yy = 3);
function f(a) = a; echo(f(1, 2), f(zz = 3));
function g() = zz; echo(g(zz = 4));
module n() echo(q); n(q = 5);
