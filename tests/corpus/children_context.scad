x = "file";
module m(x) { children(); n(x="n") children(); }
module n(x) { echo("in n", x); children(); }
m("m") { echo(x); cube(1); }
module outer() { y = 5; m("q") { z = y + 1; echo(y, z); } }
outer();
module pass() { m("p") children(); }
pass() { cube(2); sphere(3); }
module k() { children(); $z = 5; children(); }
$z = 1;
k() { w = $z; echo("child", w, $z); }
