$f = function (x) x + 1;
echo($f == undef);
g = $f; echo(g(1));
