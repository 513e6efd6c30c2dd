// used by maker_bracket.scad
$fa = 15;
unit = "mm";
LIB_SIZE = 4;
function lib_size() = LIB_SIZE * scale_of();
function scale_of() = is_undef($lib_scale) ? 1 : $lib_scale;
module lib_peg(h = 2 * LIB_SIZE) { echo("peg", h, $fa, scale_of(), unit); cylinder(d = lib_size(), h = h); children(); }
module lib_row(n, step) { for (i = [0 : n - 1]) translate([i * step, 0, 0]) { $i = i; children(i % $children); } }
echo("not shown by use");
cube(1000);
