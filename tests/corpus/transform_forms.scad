translate([1, 2, 3]) cube(); translate([1, 2]) cube(); translate(5) cube(); translate("a") cube(); translate() cube(); translate([1, "b", 3]) cube(); translate([1, 2, 3, 4]) cube(); translate([1/0, 0, 0]) cube();
scale(2) cube(); scale([1, 2, 3]) cube(); scale([2, 3]) cube(); scale("a") cube(); scale() cube(); scale(0) cube(); scale([1, 0, 1]) cube(); scale([1]) cube();
