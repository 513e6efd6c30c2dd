for (i = [0 : 10000]) cube(i);
for (i = [0 : 9998]) if (i == 9998) echo(i);
intersection_for (i = [0 : 20000]) cube(i);
