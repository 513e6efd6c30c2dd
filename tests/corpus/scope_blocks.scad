a = 1;
{ b = 2; a2 = a + b; }
echo(a, b, a2);
if (true) { a = 10; echo("inside", a); }
echo("outside", a);
translate([0,0,0]) { a = 20; echo("child", a); cube(a); }
for (i=[0:1]) { a = i * 100; echo("loop", a); }
let (a = 30) { b = a + 1; echo("let", a, b); }
echo(a, b);
