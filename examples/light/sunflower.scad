// Two thousand balls, each turned by the golden angle: a ray asks a few dozen of them, since boxes around boxes tell it which it can meet.
include <whittle.scad>

golden = 180 * (3 - sqrt(5));
for (i = [1:2000]) {
    r = 1.5 * sqrt(i);
    rotate([0, 0, i * golden]) translate([r, 0, 13 - r * r / 340]) material("plastic", roughness = 0.3,
        color = i < 700 ? [0.17 + i / 2600, 0.09 + i / 5000, 0.03] : [0.95, 0.35 + (i - 700) / 2900, 0.03])
        scale([1, 1, i < 700 ? 1.3 : 1]) sphere(i < 700 ? 1.2 : 1.5);
}
material("matte", color = [0.14, 0.3, 0.22]) translate([-900, -900, -6]) cube([1800, 1800, 2]);

area_light(p = [-120, -60, 60], u = [40, -60, 0], v = [20, 10, 70], power = 5e5, color = [1, 0.94, 0.84]);
environment(color = [0.36, 0.42, 0.5]);
camera(eye = [0, -120, 104], target = [0, -3, 2], fov = 38);
