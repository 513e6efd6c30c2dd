function f(x) = "named";
echo(f(1));
module m() { f = function(x) "value"; echo(f(1)); }
m();
module n() { f = 5; echo(f(1)); }
n();
module o() { len = function(x) "own"; echo(len("abc")); max = 3; echo(max(1,2)); }
o();
echo((5)(1));
echo("s"(2));
