wall = 2;
$fn = 30;
function volume(s) = s*s*s + wall + extra();
function extra() = 0.5;
module peg(r) { echo("peg", r, wall, $fn); cylinder(h=wall, r=r); children(); }
echo("parts must not echo");
cube(99);
