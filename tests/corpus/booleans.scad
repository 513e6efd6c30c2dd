union() { cube(1); sphere(1); }
difference() { cube(3, center=true); sphere(2); cylinder(h=9, r=1, center=true); }
intersection() { cube(3); sphere(2); }
union(); difference(); intersection() {}
union() cube(1);
difference() { for (i=[0:1]) cube(i); cube(2); }
hull() { cube(1); translate([5,0,0]) sphere(1); }
hull();
minkowski() { cube(1); sphere(1); }
minkowski(convexity=3) { cube(1); }
group() { cube(1); }
render() { cube(1); } render(convexity=5) cube(1); render(3) cube();
