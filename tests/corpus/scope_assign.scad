k = 3;
j = 99;
k = j;
echo(k, j);
y = z*2;
z = 4;
echo(y, z);
