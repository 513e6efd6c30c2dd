for (i = [0 : 9]) echo(nothing);
for (i = [0 : 2]) { echo(a1); echo(a2); }
for (i = [0 : 9]) cube(x);
