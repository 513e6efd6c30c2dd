cube("a"); cube([1,2]); cube([1,2,"a"]); cube(-1); cube(0); cube([1/0,1,1]);
sphere("a"); sphere(d=4,r=1); sphere(0); sphere(-1);
cylinder(r=1,d=3,d1=4,r2=2); cylinder(h="a"); cylinder(h=-1); cylinder(r=-1);
square("a"); square([1]); square(-1); circle("a"); circle(-1);
cube(1,foo=2); cube(1,true,3); cube(1) sphere(1); sphere(1) { }
