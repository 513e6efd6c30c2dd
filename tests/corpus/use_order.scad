use <lib/parts.scad>
use <lib/other.scad>
echo(volume(3));
peg(1);
both();
