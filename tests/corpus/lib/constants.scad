base = 4;
height = base * 2;
function area(r) = PI * r * r;
module frame() { difference() { cube([base, base, height]); cube(base/2); } }
echo("constants read", base);
