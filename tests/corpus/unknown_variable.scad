echo(a);
echo(is_undef(b), b == undef);
x = c + 1;
echo([d, e]);
function f() = g; echo(f());
module m() { echo(h); } m();
