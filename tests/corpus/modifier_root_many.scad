cube(1); !sphere(1); translate([1, 0, 0]) !cube(2);
