// Every preset by its name: balls, and a cut stone.
include <whittle.scad>

names = ["matte", "plastic", "glass", "water", "diamond", "mirror", "gold", "silver", "copper", "steel", "brushed", "emissive"];

// A brilliant of eight sides, standing on its point.
module brilliant() translate([0, 0, -2]) {
    translate([0, 0, 4]) cylinder(h = 4, r1 = 11, r2 = 6.5, $fn = 8);
    translate([0, 0, 3.5]) cylinder(h = 0.5, r = 11, $fn = 8);
    translate([0, 0, -6.5]) cylinder(h = 10, r1 = 0, r2 = 11, $fn = 8);
}

for (i = [0:11]) translate([(i % 4 - 1.5) * 30, (1 - floor(i / 4)) * 38, 0]) {
    translate([0, 0, 9]) {
        if (names[i] == "diamond") material("diamond") rotate([0, 0, 12]) brilliant();
        else if (names[i] == "matte") material("matte", color = [0.72, 0.26, 0.16]) sphere(9);
        else if (names[i] == "plastic") material("plastic", color = [0.05, 0.3, 0.55]) sphere(9);
        else if (names[i] == "emissive") material("emissive", color = [1, 0.75, 0.4], emission = [0.95, 0.66, 0.3]) sphere(9);
        else material(names[i]) sphere(9);
    }
    material("matte", color = [0.1, 0.1, 0.12]) translate([0, -16, 0]) linear_extrude(0.2) text(names[i], size = 4.4, halign = "center");
}

material("matte", color = [0.5, 0.5, 0.53]) translate([-400, -400, -2]) cube([800, 800, 2]);
for (i = [-14:14]) material("matte", color = [0.24, 0.27, 0.34]) translate([i * 10 - 0.6, -200, -1.9]) cube([1.2, 400, 2]);

area_light(p = [-190, -120, 110], u = [120, -110, 60], v = [40, 60, 90], power = 1.9e6);
area_light(p = [110, -160, 100], u = [90, 80, 0], v = [10, -10, 90], power = 7e5, color = [0.85, 0.92, 1]);
environment(color = [0.42, 0.45, 0.52]);
camera(eye = [0, -190, 195], target = [0, -5, 0], fov = 28.5);
