// While the shutter is open the propeller turns by 24 degrees, the ball flies, and the cutter that makes the slot moves: so does its slot.
include <whittle.scad>

// A propeller of two blades.
translate([-38, 0, 34]) moving(rotate = [0, 24, 0]) material("copper", roughness = 0.4) rotate([0, 35, 0]) scale([30, 3, 5]) sphere(1);
translate([-38, 1, 0]) material("plastic", color = [0.3, 0.32, 0.35]) cylinder(h = 34, r = 3);
translate([10, 6, 14]) moving(translate = [14, 0, 20]) material("plastic", color = [0.9, 0.35, 0.1]) sphere(8);

// A board whose slot is cut by a moving cutter.
material("plastic", color = [0.2, 0.45, 0.6]) difference() {
    translate([44, 0, 0]) cube([50, 5, 56]);
    moving(translate = [16, 0, 0]) translate([52, -1, 12]) cube([8, 8, 34]);
}
material("matte", color = [0.85, 0.84, 0.82]) { translate([-300, -300, -2]) cube([600, 600, 2]); }

sun(direction = [0.5, 0.7, -1], irradiance = 2.6, angle = 3);
environment(color = [0.4, 0.45, 0.52]);
camera(eye = [20, -220, 80], target = [18, 0, 28], fov = 34);
