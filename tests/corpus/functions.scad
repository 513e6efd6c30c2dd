function fact(n) = n <= 1 ? 1 : n * fact(n-1);
function even(n) = n==0 ? true : odd(n-1);
function odd(n) = n==0 ? false : even(n-1);
function fib(n) = n < 2 ? n : fib(n-1) + fib(n-2);
function last(v) = v[len(v)-1];
echo(fact(10), even(100), odd(7), fib(15), last([1,2,3]));
function noargs() = 5;
echo(noargs(), noargs(1));
