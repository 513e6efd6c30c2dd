for (i = [1]) echo("for", i);
let (a = 2) echo("let", a);
assert(true) echo("assert");
echo("x") cube();
