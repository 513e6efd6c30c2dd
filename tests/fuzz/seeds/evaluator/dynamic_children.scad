module m() { $v = 4; children(); }
m() echo($v);
module n() { echo($w); children(); }
n($w = 1) { echo($w); cube($w); }
translate([1, 0, 0], $q = 3) cube($q);
for ($i = [0 : 1]) echo($i);
let ($z = 1) echo($z);
