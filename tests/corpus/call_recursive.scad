function fact(n) = n < 2 ? 1 : n * fact(n - 1); echo(fact(10), fact(20), fact(170), fact(171));
function fib(n) = n < 2 ? n : fib(n - 1) + fib(n - 2); echo([for (i = [0 : 15]) fib(i)]);
function even(n) = n == 0 ? true : odd(n - 1); function odd(n) = n == 0 ? false : even(n - 1); echo(even(100), odd(7));
