// A lens with six blades: the third pawn is in its plane of focus, the lamps far behind become hexagons.
include <whittle.scad>

module pawn() rotate_extrude() polygon([[0, 0], [9, 0], [9, 3], [6, 6], [3.6, 16], [5.5, 17.5], [3.6, 19], [0, 19]]);
module head() translate([0, 0, 22.5]) sphere(5.2);

for (i = [0:5]) translate([i * 13 - 26, i * 34 - 68, 0]) material("plastic", color = i == 2 ? [0.8, 0.15, 0.1] : [0.82, 0.78, 0.68], roughness = 0.25) { pawn(); head(); }
for (x = [-6:5], y = [-7:12]) material("plastic", color = (x + y) % 2 == 0 ? [0.16, 0.1, 0.07] : [0.8, 0.7, 0.52], roughness = 0.35)
    translate([x * 26, y * 26, -4]) cube([26, 26, 4]);
// Fairy lights.
for (i = [0:17]) material("emissive", emission = [9, 6, 2.6] * (0.6 + 0.6 * abs(sin(i * 67)))) translate([i * 36 - 260, 620 + 60 * sin(i * 131), 60 + 42 * sin(i * 97)]) sphere(2.6);

light(p = [-120, -160, 220], r = 25, power = 2.2e6);
environment(color = [0.1, 0.12, 0.18]);
camera(eye = [-34, -190, 46], target = [2, 0, 16], fov = 24, aperture = 12, focus = 190, blades = 6);
