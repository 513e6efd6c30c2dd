function count(n, a = 0) = n == 0 ? a : count(n - 1, a + 1); echo(count(100000));
function l(n) = let (m = n - 1) m < 0 ? "done" : l(m); echo(l(5000));
function e(n) = n > 2 ? echo("end") n : echo(n) e(n + 1); echo(e(0));
function s(n) = assert(n >= 0) n == 0 ? "zero" : s(n - 1); echo(s(1000));
function d(n, $k) = n == 0 ? $k : d(n - 1, $k + 1); echo(d(10, 5));
