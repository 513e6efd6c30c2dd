2d = 5;
3x_y = 6;
_a = 1;
echo(2d, 3x_y, _a, 2d*2);
