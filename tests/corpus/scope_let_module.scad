a = 1;
let (a = 2, b = a + 1) { echo(a, b); c = b; cube(c); }
echo(a, is_undef(b));
let () echo("empty");
let (a = 1, a = 2) echo(a);
