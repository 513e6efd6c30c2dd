a = 1; function a() = 2; module a() echo(3);
echo(a, a()); a();
function f(x) = 1; function f(x) = 2; echo(f(0));
module m() echo("first"); module m() echo("second"); m();
len = 5; echo(len, len("abc"));
sin = function (x) 42; echo(sin(90));
