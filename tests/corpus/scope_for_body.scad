for (i = [1 : 3]) { j = i * 2; k = j + i; echo(i, j, k); }
echo(is_undef(j));
for (i = [0 : 1]) { i = 7; echo(i); }
