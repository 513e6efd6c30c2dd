function f(x) = 1+f(x); echo(f(1)); echo("x");
