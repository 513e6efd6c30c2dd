m=5; module q(a=echo("d") 1, b) echo(a,b); q(); q(2); q(a=echo("g") 3); function f(a=echo("fd") 1) = a; echo(f(), f(2));
