function f(x) = 1 + f(x);
echo("before");
echo(f(1));
echo("after");
