// The classic of constructive solid geometry: a cube rounded by a ball, drilled three ways.
size = 20;     // edge of the cube
round_r = 13.5;
bore_r = 6;

module bore() cylinder(h = size, r = bore_r, center = true);  // flush with the cube: nothing to add

difference() {
    color("orangered") intersection() {
        cube(size, center = true);
        sphere(round_r);
    }
    color("gold") union() {
        bore();
        rotate([90, 0, 0]) bore();
        rotate([0, 90, 0]) bore();
    }
}

// A ball less six caps of height k = round_r - size/2, less the union of three crossing cylinders (Steinmetz).
// fact: volume = 3116.06186365; 4/3 pi R^3 - 6 pi k^2 (R - k/3) - (3 pi c^2 a - 16 c^3 + 8 (2 - sqrt 2) c^3)
// fact: area = 2420.79616395; 4 pi R^2 - 12 pi R k + 6 pi (R^2 - a^2/4 - c^2) + 3 (2 pi c a - 8 sqrt 2 c^2)
// fact: genus = 5; six mouths meet in one cave
// fact: components = 1; one skin
// perturb: bore_r = 6.05
