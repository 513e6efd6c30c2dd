a = undef; echo(a + 1);
b = a[0]; echo(b);
c = a.x; echo(c);
echo(a * [1, 2], [1, 2] + a, -a, a < 1, a == 1, a && 1, str(a), len(a), max(a, 1), a ? 1 : 2, [a][0], a(1));
