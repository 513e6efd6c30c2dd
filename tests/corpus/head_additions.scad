linear_extrude(h=5) circle(1);
rotate_extrude(90) square(1);
echo(0x10, 6 & 3, 6 | 3, 1 << 4, 256 >> 4, ~0);
