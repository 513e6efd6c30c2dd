include <lib/sizes.scad>
use <lib/pegs.scad>
use <missing_lib.scad>
width = 40; // overrides sizes
height = width / 2;
$lib_scale = 1.5;
echo(width, height, depth, LIB_SIZE, lib_size(), unit);
module plate(w, h, t = thickness) difference() {
    linear_extrude(t) offset(r = 2, $fn = 16) offset(delta = -2) square([w, h]);
    for (x = [6 : (w - 12) / 2 : w - 6], y = [6, h - 6]) translate([x, y, -1]) cylinder(d = 3, h = t + 2, $fn = 12);
}
plate(width, height);
rotate([90, 0, 0]) plate(w = width, h = depth);
for (x = [4, width - 4]) translate([x, 0, 0]) rotate([90, 0, 90]) linear_extrude(3, center = true) polygon([[0, 0], [depth / 2, 0], [0, depth / 2]]);
lib_row(3, 12, $lib_scale = 0.5) { lib_peg(); lib_peg(3) sphere(1); }
translate([0, 40, 0]) lib_peg($fa = 60);
module tab(n) { if (n > 0) { translate([0, -5 * n, 0]) cube([width, 3, 1]); tab(n - 1); } else echo("last tab", $children, parent_module(1), parent_module(0)); }
tab(3);
width = 44;
