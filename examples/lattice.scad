// A cubic lattice of rods and ball nodes: light, stiff, and the genus of a sponge.
n = 4;         // nodes along an edge
pitch = 12;
ball_r = 2.6;
rod_r = 1.2;

function along(axis) = axis == 0 ? [0, 90, 0] : axis == 1 ? [-90, 0, 0] : [0, 0, 0];
function tint(i, j, k) = [0.25 + 0.65 * i / (n - 1), 0.35 + 0.5 * j / (n - 1), 0.95 - 0.6 * k / (n - 1)];

for (i = [0 : n - 1], j = [0 : n - 1], k = [0 : n - 1]) {
    color(tint(i, j, k)) translate([i, j, k] * pitch) sphere(ball_r);
    for (axis = [0 : 2])
        if ([i, j, k][axis] < n - 1)
            color("gainsboro") translate([i, j, k] * pitch) rotate(along(axis)) cylinder(h = pitch, r = rod_r);
}

// Rods meet only inside balls, as sqrt(2) r < R. With q = sqrt(R^2 - r^2):
// fact: volume = 9328.99335804; n^3 4/3 pi R^3 + 3 n^2 (n - 1) (pi r^2 p - 4/3 pi (R^3 - q^3))
// fact: area = 12076.1932385; n^3 4 pi R^2 + 3 n^2 (n - 1) (2 pi r (p - 2 q) - 4 pi R (R - q))
// fact: genus = 81; rods - balls + 1
// fact: components = 1; one skin
// perturb: rod_r = 1.22
