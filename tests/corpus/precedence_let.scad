echo(let (a = 1) a + 2, (let (a = 1) a) + 2, true ? let (b = 3) b : 4, assert(true) 5 + 1, 1 + (assert(true) 2));
x = let (a = 1, b = a + 1) [a, b]; echo(x);
f = function (x) x ? 1 : 2; echo(f(0), (function (x) x + 1)(2) * 3);
