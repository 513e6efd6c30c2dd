a = 1;
{ a = 2; b = 3; { c = 4; } }
echo(a, b, c);
{ module m() echo("m"); function f() = "f"; }
m(); echo(f());
