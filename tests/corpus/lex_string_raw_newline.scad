a = "one
two

three";
echo(a, len(a));
echo("after");
