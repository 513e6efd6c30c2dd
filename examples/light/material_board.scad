// Every preset by its name, on the same little sculpture.
include <whittle.scad>

names = ["matte", "plastic", "glass", "water", "diamond", "mirror", "gold", "silver", "copper", "steel", "brushed", "emissive"];

// A cube with rounded corners, a ball cut out of its front, a ball in the hollow.
module sculpture() {
    difference() {
        roundcube([20, 20, 20], r = 3, center = true);
        translate([0, -10, 2]) sphere(7.5);
    }
    translate([0, -9, 2]) sphere(4.5);
}

for (i = [0:11]) translate([(i % 4 - 1.5) * 32, (1 - floor(i / 4)) * 36, 10.01]) rotate([0, 0, 28])
    if (names[i] == "emissive") material("emissive", color = [1, 0.75, 0.4], emission = [2.2, 1.5, 0.7]) sculpture();
    else material(names[i]) sculpture();

material("matte", color = [0.55, 0.56, 0.58]) translate([-400, -400, -2]) cube([800, 800, 2]);
for (i = [-8:8]) material("matte", color = [0.3, 0.32, 0.36]) translate([i * 16 - 0.5, -200, -1.99]) cube([1, 400, 2]);

area_light(p = [-120, -150, 160], u = [120, 0, 0], v = [0, 60, 70], power = 1.5e6);
environment(color = [0.42, 0.45, 0.52]);
camera(eye = [30, -230, 190], target = [0, -4, 4], fov = 25);
