// A lens with six blades: the red pawn is in its plane of focus, the lamps far behind become hexagons.
include <whittle.scad>

module pawn() rotate_extrude() polygon([[0, 0], [9, 0], [9, 3], [6, 6], [3.6, 16], [5.5, 17.5], [3.6, 19], [0, 19]]);
module head() translate([0, 0, 22.5]) sphere(5.2);

for (i = [0:5]) translate([i * 15 - 34, i * 38 - 66, 0]) material("plastic", color = i == 2 ? [0.78, 0.1, 0.06] : [0.84, 0.8, 0.7], roughness = 0.25) { pawn(); head(); }
for (x = [-5:5], y = [-6:12]) material("plastic", color = (x + y) % 2 == 0 ? [0.13, 0.08, 0.05] : [0.8, 0.7, 0.52], roughness = 0.3)
    translate([x * 26, y * 26, -4]) cube([26, 26, 4]);
// Fairy lights, of different colours.
hues = [[9, 5.2, 1.8], [9, 2.2, 1], [2.4, 5, 9], [7, 7, 6]];
for (i = [0:23]) material("emissive", emission = hues[(i * 7) % 4] * (0.35 + 0.3 * abs(sin(i * 67)))) translate([i * 27 - 290, 560 + 70 * sin(i * 131), 62 + 56 * sin(i * 97)]) sphere(5);

light(p = [-120, -160, 220], r = 25, power = 2e6, color = [1, 0.95, 0.88]);
environment(color = [0.1, 0.12, 0.19]);
camera(eye = [-30, -180, 44], target = [-2, 10, 18], fov = 24, aperture = 13, focus = 192, blades = 6);
