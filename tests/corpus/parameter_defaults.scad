d = 10;
module m(a, b=a, c=d+1) { echo(a, b, c); }
m(1);
function f(x, y=x, z=d*2) = [x, y, z];
echo(f(1), f(1,2), f(1,2,3));
