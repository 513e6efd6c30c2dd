x = 1;
if (true) { x = 2; echo(x); y = x + 1; echo(y); }
echo(x);
if (false) { } else { x = 5; echo(x); }
