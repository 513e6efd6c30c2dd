// Calls that call themselves, most of them not in tail position.
function fib(n) = n < 2 ? n : fib(n - 1) + fib(n - 2);
function ackermann(m, n) = m == 0 ? n + 1 : n == 0 ? ackermann(m - 1, 1) : ackermann(m - 1, ackermann(m, n - 1));
function depth(n) = n == 0 ? 0 : 1 + depth(n - 1);
function sum_to(n, total = 0) = n == 0 ? total : sum_to(n - 1, total + n);
echo(fib(25), ackermann(2, 100), depth(2000), sum_to(400000));
