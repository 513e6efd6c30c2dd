// A prism of flint glass spreads a ribbon of sunlight into its colours. Nothing is painted: each wavelength has its own index (Abbe number 14), and the rays
// of the sun are followed through both faces onto the table and the white card.
include <whittle.scad>

side = 34;
index = 1.66;
turned = 30 - asin(index * sin(30));          // light passes the prism evenly: least deviation
deviation = 2 * asin(index * sin(30)) - 60;

material("glass", ior = index, dispersion = 14)
    rotate([0, 0, turned]) translate([0, 0, 0.01]) linear_extrude(26) polygon([for (a = [90, 210, 330]) side / sqrt(3) * [cos(a), sin(a)]]);

// A wall with a slit lets the ribbon through and keeps the rest of the sun out.
material("matte", color = [0.1, 0.1, 0.12]) difference() {
    translate([-62, -240, 0]) cube([2, 480, 120]);
    translate([-63, 6.7, 3]) cube([4, 2.2, 30]);
}
material("matte", color = [0.34, 0.34, 0.37]) translate([-300, -300, -2]) cube([600, 600, 2]);
// The card stands across the bent light.
material("matte", color = [0.88, 0.88, 0.88]) rotate([0, 0, -deviation]) translate([92, -34, 0]) cube([2, 68, 34]);

sun(direction = [1, 0, -0.14], irradiance = 70, angle = 0.15, color = "white");
environment(color = [0.44, 0.46, 0.52]);
camera(eye = [14, -92, 150], target = [20, -22, 0], fov = 36);
// integrator: caustics
