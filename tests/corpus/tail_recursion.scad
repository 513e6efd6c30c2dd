function f(n, acc=0) = n == 0 ? acc : f(n-1, acc+n);
echo(f(100000));
function g(n) = let(m = n-1) m < 0 ? "done" : g(m);
echo(g(50000));
function h(n) = assert(n >= 0) n == 0 ? "ok" : h(n-1);
echo(h(20000));
