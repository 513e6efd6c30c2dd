// Three cylinders, and only what all three share: the tricylinder that Archimedes could have carved.
r = 10;

module rod(tint) color(tint) cylinder(h = 3 * r, r = r, center = true);

intersection() {
    rod("crimson");
    rotate([90, 0, 0]) rod("goldenrod");
    rotate([0, 90, 0]) rod("teal");
}

// fact: volume = 4686.29150102; 8 (2 - sqrt 2) r^3
// fact: area = 1405.8874503; 24 (2 - sqrt 2) r^2
// fact: genus = 0; it is convex
// fact: components = 1; so it has one skin
// perturb: r = 10.03
