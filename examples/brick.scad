// A toy brick of 2 by 4 studs, hollow below, with the tubes that grip the studs of its neighbour.
columns = 4;
rows = 2;
pitch = 8;
height = 9.6;
wall = 1.5;
roof = 1;
stud_r = 2.4;
stud_h = 1.8;
tube_r = 3.255;
gap = 0.2;       // all round, so that bricks fit side by side

outer = [columns * pitch - gap, rows * pitch - gap, height];

module studs() for (i = [0.5 : columns - 0.5], j = [0.5 : rows - 0.5])
    translate([i * pitch - gap / 2, j * pitch - gap / 2, height]) cylinder(h = stud_h, r = stud_r);

module tubes() for (i = [1 : columns - 1], j = [1 : rows - 1])
    translate([i * pitch - gap / 2, j * pitch - gap / 2, 0]) difference() {
        cylinder(h = height - roof, r = tube_r);
        cylinder(h = height - roof, r = stud_r);
    }

color("crimson") {
    difference() {
        cube(outer);
        translate([wall, wall, 0]) cube([outer.x - 2 * wall, outer.y - 2 * wall, height - roof]);
    }
    studs();
    tubes();
}

// fact: volume = 2305.58997977; box - cavity + 8 pi r^2 h + 3 pi (R^2 - r^2) (height - roof)
// fact: area = 3768.17733735; box + cavity's walls + 8 studs' walls + 3 tubes' walls; what a face loses, another gains
// fact: genus = 0; tubes are closed by the roof
// fact: components = 1; one skin
// perturb: stud_h = 1.85
