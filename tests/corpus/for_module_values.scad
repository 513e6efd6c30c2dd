for (i = [1, "a", [2], undef]) echo(i);
for (c = "xy") echo(c);
for (i = 7) echo(i);
for (i = undef) echo("never");
for (i = [0 : 0]) echo(i);
for () echo("no variable");
for (a = [0, 1], b = [a : 1]) echo(a, b);
