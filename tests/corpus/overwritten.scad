a = 1;
a = 2;
module m(p) { p = 3; q = p; q = 4; echo(p, q); }
m(1);
if (true) { c = 1; c = 2; echo(c); }
echo(a);
