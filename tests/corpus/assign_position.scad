k = 3; j = 99; k = j;
echo(k, j);
