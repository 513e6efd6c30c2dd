$q = 1;
module m() { echo($q); children(); }
m();
m($q=2);
m($q=3) m();
module n($q=4) { m(); children(); }
n();
n($q=5) m();
n(6) echo($q);
let ($q=7) m();
for ($q=[8,9]) m();
function f() = $q;
function g($q) = f();
echo(f(), g(10), let($q=11) f(), f($q=12));
translate([1,0,0], $q=13) m();
m() { $q = 14; m(); echo($q); }
echo($q);
