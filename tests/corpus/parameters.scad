module m(a, b=2, c) { echo(a, b, c); }
m(); m(1); m(1,2,3); m(c=3); m(b=9,4); m(1,a=2); m(1,2,3,4); m(zz=5); m(1,2,3,4,5);
function f(a, b=2, c) = [a, b, c];
echo(f(), f(1), f(1,2,3), f(c=3), f(b=9,4), f(1,a=2), f(1,2,3,4), f(zz=5), f(a=1,5));
