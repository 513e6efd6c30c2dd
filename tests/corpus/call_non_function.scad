x = 5; echo(x(1));
y = [1]; echo(y[0](2));
echo(undef(1));
echo("a"(1));
nofunc(1);
echo(nofunc(1));
