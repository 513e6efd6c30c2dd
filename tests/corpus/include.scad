include <lib/constants.scad>
echo(base, height, area(2));
base = 7;
include <lib/missing.scad>
frame();
