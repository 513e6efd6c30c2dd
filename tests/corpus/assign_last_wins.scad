a = 1;
echo(a);
b = a;
a = 2;
echo(a, b);
