echo(1 < "a");
echo("a" <= [1]);
echo(undef < undef);
echo(undef > 1);
echo([1] < 1);
echo([1, "a"] < [1, 2]);
echo(true < 1);
f = function (x) x; echo(f < f);
echo([0:1] < [1]);
