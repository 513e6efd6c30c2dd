function f(x) = assert(x > 0, "positive please") x * 2;
echo(f(1));
echo(assert(true, "fine") 3, assert(1), assert([0]) "v");
echo(f(-1));
echo("never");
