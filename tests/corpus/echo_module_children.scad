echo("a") cube(1);
echo("b") { cube(2); sphere(3); }
echo("c");
echo(a = 1, b = [1, "x"], 3);
