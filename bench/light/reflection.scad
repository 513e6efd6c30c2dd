// Three mirror balls and a mirror block on a chequered floor, one lamp without a size.
include <whittle.scad>

for (i = [-1:1]) material("mirror") translate([i * 26, 6 * i * i, 11]) sphere(11);
material("mirror") translate([-50, 34, 0]) cube([100, 4, 34]);
for (x = [-5:4], y = [-5:4]) material("matte", color = (x + y) % 2 == 0 ? [0.85, 0.8, 0.7] : [0.15, 0.25, 0.4]) translate([x * 18, y * 18, -2]) cube([18, 18, 2]);

light(p = [50, -80, 110], power = 9e5);
environment(color = [0.35, 0.4, 0.5]);
camera(eye = [10, -130, 62], target = [0, 6, 8], fov = 34);
