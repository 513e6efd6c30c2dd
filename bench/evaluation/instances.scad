// A hundred thousand parts in nested loops.
for (x = [0 : 99], y = [0 : 99]) translate([x * 3, y * 3, 0]) for (z = [0 : 9]) translate([0, 0, z * 2]) cube([1, 1 + (x + y) % 3, 1]);
