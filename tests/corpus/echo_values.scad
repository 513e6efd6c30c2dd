echo(undef, true, 1, "s", [1, "a", [undef, [true]]], [0:5], [0:0.5:2], function (a, b = 2) a + b * 2);
echo(v = [1, 2], w = "x");
echo();
echo("");
echo([]);
echo([[]]);
