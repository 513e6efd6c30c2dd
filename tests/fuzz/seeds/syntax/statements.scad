function f(x, y = 2) = x + y;
module m(a, b = [1, 2]) { t = a; translate([a, 0]) { cube(t); sphere(1, $fn = 5); } children(); module inner() cube(); function g() = 1; if (a > 1) cube(); else { sphere(); cube(2); } for (i = [0:2]) cube(i); }
%m(1) #cube(2);
!sphere(3);
*cube(9);
z = f(1);
if (z) cube(1); else if (z > 2) sphere(2); else ;
difference() { cube(); sphere(); }
{ w = 3; cube(w); }
let (q = 1) cube(q);
echo("a", b = 1);
union();
m(1) { k = 2; cube(k); }
