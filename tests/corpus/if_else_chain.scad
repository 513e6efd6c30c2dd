module t(x) if (x == 0) echo("zero"); else if (x == 1) echo("one"); else { echo("many"); echo(x); }
for (i = [0 : 2]) t(i);
if (false) cube(1); else sphere(1);
if (true) { } else cube(2);
if (undef) cube(3);
if ([]) cube(4); else if ("") cube(5); else if (0) cube(6); else cube(7);
