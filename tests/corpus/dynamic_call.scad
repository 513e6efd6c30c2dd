function f() = $a;
echo(f($a = 3), is_undef($a));
$a = 1; echo(f(), f($a = 2));
function g(x) = f($a = x) + f(); echo(g(10));
module m() { echo($a); n(); } module n() echo($a * 2); m($a = 5); m();
