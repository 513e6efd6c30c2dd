// Roughness from none to all, in gold (complex index, energy of all bounces) above and in glass (microfacets on both sides) below.
include <whittle.scad>

for (i = [0:4]) translate([(i - 2) * 26, 0, 0]) {
    material("gold", roughness = i * 0.22) translate([0, 14, 38]) sphere(11);
    material("glass", roughness = i * 0.15) translate([0, -8, 11]) sphere(11);
}
// Shelf for the gold.
material("matte", color = [0.25, 0.27, 0.3]) translate([-75, 6, 22]) cube([150, 30, 4]);
material("matte", color = [0.75, 0.74, 0.72]) translate([-400, -400, -2]) cube([800, 800, 2]);
for (i = [-9:9]) material("matte", color = i % 2 == 0 ? [0.2, 0.25, 0.32] : [0.8, 0.8, 0.78]) translate([i * 12 - 6, 44, -1]) cube([12, 2, 80]);

area_light(p = [-100, -120, 120], u = [90, 0, 0], v = [0, 50, 50], power = 8e5);
environment(color = [0.4, 0.43, 0.5]);
camera(eye = [0, -210, 62], target = [0, 5, 25], fov = 36);
