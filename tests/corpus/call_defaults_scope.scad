a = 10;
module m(a, b = a + 1) echo(a, b);
m(1); m(1, 2); m(b = 5);
function f(x = y, y = 2) = [x, y]; echo(f());
function g(n = echo("default") 1) = n; echo(g(), g(5));
