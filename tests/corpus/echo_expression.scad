x = echo("in let") 5; echo(x);
function f(n) = echo(n = n, "call") n <= 0 ? 0 : f(n - 1); echo(f(2));
echo([for (i = [0 : 1]) echo("loop", i) i]);
y = echo() 1;
