f = function (x) x * 2; g = function (x, y = 3) x + y;
echo(f(4), g(1), g(1, 1), g(y = 0, x = 5), (function (x) x)(1), [f, g][1](2), f(f(f(1))));
h = function (n) n == 0 ? 0 : n + h(n - 1); echo(is_function(h), is_function(1), is_function(f(1)));
k = function () function (x) x + 1; echo(k()(2));
