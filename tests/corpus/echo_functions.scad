echo(function (x) x, function () undef, function (x, y = [1, 2]) x ? y : -x, function (a) let (b = a) [for (i = [0:b]) if (i > 1) i else each [i]]);
echo(function (x) x.y[0](1, z = 2) && !x || x % 2 ^ 3, function (f) function (g) f(g), function (s) str("a", s), function (r) [1 : r : 3], function (e) assert(e) echo(e) e);
