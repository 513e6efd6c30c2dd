function f(n) = f(n+1);
echo("before");
echo(f(0));
echo("after");
