color("nosuch") cube(1);
color("#gg0000") cube(1);
