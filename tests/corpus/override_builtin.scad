module cube(a) { echo("my cube", a); sphere(a); }
cube(2);
function sin(x) = "sine"; echo(sin(1));
module translate(v) { echo(v); children(); }
translate([1, 2]) cylinder();
