x=1; function f(y) = let(x=2) x+y; echo(f(1), x); a = let(b=1,b=2) b; echo(a); module m(x) { module n() echo(x); n(); } m(5); function g(x) = function(y) x+y; echo(g(1)(2)); let(x=5,x=6) echo(x);
