echo([for (i = [5 : 1]) i]);
r = [3 : 0]; echo(r, [for (i = r) i]);
for (i = [2 : 0]) echo(i);
