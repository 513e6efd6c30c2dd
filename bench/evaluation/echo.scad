// Messages: numbers, lists and strings to text.
for (k = [0 : 4]) for (i = [0 : 7999]) echo(i, i / 3, [i, sqrt(i), -i * 1e6], str("item ", i), a = i % 2 == 0);
