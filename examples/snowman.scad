// A snowman in the evening sun.
include <whittle.scad>

body_r = 20;
chest_r = 14;
head_r = 10;
chest_z = 25;
head_z = 45;

color("snow") {
    sphere(body_r);
    translate([0, 0, chest_z]) sphere(chest_r);
    translate([0, 0, head_z]) sphere(head_r);
}
color("darkorange") translate([0, 0.5 - head_r, head_z]) rotate([90, 0, 0]) cylinder(h = 9, r1 = 1.8, r2 = 0);
color("black") {
    for (x = [-3.6, 3.6]) translate([x, -8.6, head_z + 3.6]) sphere(1.2);
    for (a = [-12, 4, 20])
        translate([0, 0, chest_z]) rotate([a, 0, 0]) translate([0, -chest_r, 0]) sphere(1.1);
    translate([0, 0, head_z + 7]) cylinder(h = 1.2, r = 11);   // brim
    translate([0, 0, head_z + 8.2]) cylinder(h = 12, r = 7);   // hat
}
color("aliceblue") translate([-90, -90, -21]) cube([180, 180, 3]);

sun(direction = [0.8, 0.9, -0.7], color = [1, 0.86, 0.7], angle = 1);
environment(color = [0.55, 0.65, 0.85], intensity = 0.6);
camera(eye = [34, -165, 58], target = [0, 0, 23], fov = 36);

// fact: volume = 146086.36479; balls and lenses, hat, meadow less the cap of snow in it; the nose beyond the head by quadrature
// fact: genus = 0; nothing goes through
// fact: components = 1; he stands 2 mm deep in the snow
// perturb: chest_r = 14.6
