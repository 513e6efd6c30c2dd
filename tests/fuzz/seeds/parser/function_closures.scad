function adder(n) = function (x) x + n;
a = adder(1); b = adder(10); echo(a(1), b(1));
module m(f) echo(f(3)); m(function (x) x ^ 2); m(adder(5));
v = [for (i = [0 : 2]) i]; p = 5; q = function (x) x + p; echo(q(1));
function apply(fn, x) = fn(x); echo(apply(function (z) z * p, 3));
