// Which types have an order, and which comparisons are undefined.
echo(1 < 2, "a" < "b", "A" < "a", "" < "a", true < false, false < true, [1, 2] < [1, 3], [1] < [1, 0], [] < [0]);
echo([1:2] < [1:3], [1:2:9] > [1:1:9], [0:1] <= [0:1]);
echo(undef < undef, 1 < "a", [1] < 1, true < 1);
echo([1, "a"] < [1, 2], [2, "a"] < [1, 2]);
f = function(x) x;
echo(f < f, f == f, f == (function(x) x));
echo("ä" < "z", "é" > "e");
