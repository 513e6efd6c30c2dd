function f(n) = n==0 ? 0 : f(n-1); echo(f(1000001)); echo("after");
