base = 1;
include <lib/constants.scad>
echo(base, height);
include <lib/constants.scad>
height = 50;
echo(height);
