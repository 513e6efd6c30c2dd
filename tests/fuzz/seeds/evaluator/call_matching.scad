module m(a, b, c) echo(a, b, c);
m(1, 2, 3); m(c = 3, 1); m(b = 9, 4); m(1, a = 2); m(a = 1, 5); m(b = 1, b = 2); m();
function f(a, b) = [a, b]; echo(f(a = 1, 5), f(b = 1, 5), f(5, b = 1), f(b = 2));
