use <lib/parts.scad>
use <lib/missing.scad>
echo(volume(3), is_undef(wall));
peg(2);
peg(3, $fn=6);
peg(1) cube(1);
$fn = 9;
peg(4);
