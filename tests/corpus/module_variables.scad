module m(x) { y = x * 2; z = y + 1; echo(x, y, z); }
m(1); m(x = 2);
module n(x = 1) { x = 5; echo(x); }
n(); n(3);
