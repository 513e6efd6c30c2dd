function check(v) = assert(len(v) == 3, "three please") v;
function wrap(v) = check(v)[0];
module m(v) { translate([wrap(v),0,0]) cube(1); }
m([1,2,3]);
union() { m([1,2]); }
echo("never");
