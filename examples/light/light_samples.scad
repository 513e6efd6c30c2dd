// One penumbra, four strips: 1, 10, 20 and 50 rays to the lamp at a single sample a pixel. Each strip of docs/gallery/light_samples.png is
//   whittle render light_samples.scad --imgsize 480,80 --samples 1 --light-samples N --integrator distributed
include <whittle.scad>

material("matte", color = [0.85, 0.83, 0.8]) translate([-200, -60, -2]) cube([400, 200, 2]);
// A comb whose teeth end higher and higher above the floor: the farther, the softer.
for (i = [0:12]) material("matte", color = [0.2 + 0.05 * i, 0.35, 0.75 - 0.05 * i]) translate([i * 14 - 87, 18, 0]) cylinder(h = 6 + 2.4 * i, r = 2.5);

area_light(p = [-30, 110, 60], u = [60, 0, 0], v = [0, 26, 30], power = 1.8e6);
environment(color = "black");
camera(eye = [0, -110, 95], target = [0, 4, 0], fov = 13);
