cube(); cube(2); cube([1,2,3]); cube(2, true); cube(size=[1,2,3], center=true);
sphere(); sphere(2); sphere(d=3); sphere(r=4, $fn=20);
cylinder(); cylinder(10,5); cylinder(10,5,3); cylinder(h=4, r=2); cylinder(h=4, d=2); cylinder(h=4, d1=2, d2=6); cylinder(h=4, r1=1, r2=2, center=true); cylinder(5,2,1,true); cylinder(r1=1,r=3);
square(); square(2); square([1,2]); square([1,2], true);
circle(); circle(2); circle(d=3); circle(r=4, $fn=5);
