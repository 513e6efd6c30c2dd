// A row of balls that recedes on chequers, seen through a wide lens.
include <whittle.scad>

for (i = [0:7]) material("matte", color = [0.9 - 0.1 * i, 0.25 + 0.06 * i, 0.15 + 0.1 * i]) translate([i * 15 - 40, i * 40 - 60, 9]) sphere(9);
for (x = [-6:5], y = [-5:14]) material("matte", color = (x + y) % 2 == 0 ? [0.85, 0.8, 0.7] : [0.15, 0.25, 0.4]) translate([x * 24, y * 24, -2]) cube([24, 24, 2]);

light(p = [-90, -140, 200], power = 3e6);
environment(color = "black");
camera(eye = [-20, -190, 50], target = [-4, 20, 8], fov = 26, aperture = 12, focus = 190);
