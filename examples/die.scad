// A die: a cube rounded by a ball, its pips half balls. Each cutter gives its face its own colour.
size = 16;
round_r = 11;
pip_r = 1.4;
spread = 4;

layout = [
    [[0, 0]],
    [[-1, -1], [1, 1]],
    [[-1, -1], [0, 0], [1, 1]],
    [[-1, -1], [1, -1], [-1, 1], [1, 1]],
    [[-1, -1], [1, -1], [0, 0], [-1, 1], [1, 1]],
    [[-1, -1], [1, -1], [-1, 0], [1, 0], [-1, 1], [1, 1]]
];
// How face n + 1 is turned up; opposite faces add up to seven.
turn = [[0, 0, 0], [90, 0, 0], [0, 90, 0], [0, -90, 0], [-90, 0, 0], [180, 0, 0]];

module pips(n) for (p = layout[n]) translate([p.x * spread, p.y * spread, size / 2]) sphere(pip_r);

difference() {
    color("ivory") intersection() {
        cube(size, center = true);
        sphere(round_r);
    }
    for (n = [0 : 5]) color(n == 0 ? "crimson" : "midnightblue") rotate(turn[n]) pips(n);
}

// The corner pips' mouths reach 7.06 from the face's middle, the face is a disc of radius sqrt(11^2 - 8^2) = 7.55.
// fact: volume = 3758.13230625; 4/3 pi R^3 - 6 pi k^2 (R - k/3) - 21 * 2/3 pi r^3, k = R - a/2
// fact: area = 1480.19279467; 4 pi R^2 - 12 pi R k + 6 pi (R^2 - a^2/4) + 21 pi r^2
// fact: genus = 0; nothing goes through
// fact: components = 1; one skin
// perturb: pip_r = 1.45
