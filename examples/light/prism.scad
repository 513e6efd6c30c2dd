// A prism of flint glass spreads a ribbon of sunlight into its colours. Nothing is painted: each wavelength has its own index (Abbe number 14), and the rays
// of the sun are followed through both faces onto the white card.
include <whittle.scad>

side = 34;
index = 1.66;
turned = 30 - asin(index * sin(30));          // light passes the prism evenly: least deviation
deviation = 2 * asin(index * sin(30)) - 60;

material("glass", ior = index, dispersion = 14)
    rotate([0, 0, turned]) translate([0, 0, 0.01]) linear_extrude(40) polygon([for (a = [90, 210, 330]) side / sqrt(3) * [cos(a), sin(a)]]);

// A wall with a slit lets the ribbon through and keeps the rest of the sun out.
material("matte", color = [0.08, 0.08, 0.1]) difference() {
    translate([-70, -240, -2]) cube([2, 480, 90]);
    translate([-71, 6.7, 4]) cube([4, 2.4, 40]);
}

material("matte", color = [0.8, 0.8, 0.82]) {
    translate([-68, -240, -2]) cube([400, 480, 2]);
    // The card stands across the bent light.
    rotate([0, 0, -deviation]) translate([105, -42, 0]) cube([2, 84, 52]);
}

sun(direction = [1, 0, -0.08], irradiance = 90, angle = 0.25, color = "white");
environment(color = [0.46, 0.48, 0.54]);
camera(eye = [-46, 96, 105], target = [26, -26, 10], fov = 38);
// integrator: caustics
