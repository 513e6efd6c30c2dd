// Menger's sponge: at every level, bars of a third go through every cube, three ways, and each ends flush in the faces it opens.
level = 3;
size = 27;

module bars(n, s) {  // square holes along z through [0, s]^2, n levels deep
    translate([s / 3, s / 3, 0]) cube([s / 3, s / 3, size]);
    if (n > 1)
        for (i = [0 : 2], j = [0 : 2])
            if (i != 1 || j != 1) translate([i * s / 3, j * s / 3, 0]) bars(n - 1, s / 3);
}

difference() {
    color("burlywood") cube(size);
    color("firebrick") bars(level, size);
    color("darkorange") translate([0, size, 0]) rotate([90, 0, 0]) bars(level, size);
    color("saddlebrown") translate([0, 0, size]) rotate([0, 90, 0]) bars(level, size);
}

// fact: volume = 8000; size^3 (20/27)^level
// fact: area = 18048; size^2 (2 (20/9)^level + 4 (8/9)^level)
// fact: genus = 1409; Euler's number of its 8000 small cubes
// fact: components = 1; one skin
// perturb: size = 27.001
