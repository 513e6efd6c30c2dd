// While the shutter is open the propeller turns by 20 degrees, the ball flies, and the cutter that makes the slot moves: so does its slot.
include <whittle.scad>

// A propeller of three blades before its motor.
translate([-34, 0, 38]) {
    moving(rotate = [0, 20, 0]) {
        for (k = [0:2]) rotate([0, k * 120 + 10, 0]) translate([15, -6, 0]) rotate([28, 0, 0]) material("copper", roughness = 0.35) scale([15, 1.4, 4.5]) sphere(1);
        material("steel", roughness = 0.3) translate([0, -6, 0]) sphere(4.5);
    }
    material("plastic", color = [0.2, 0.22, 0.25]) { rotate([-90, 0, 0]) cylinder(h = 12, r = 5, center = true); translate([0, 3, -38]) cylinder(h = 36, r = 2.5); }
}
translate([4, -4, 12]) moving(translate = [12, 0, 26]) material("plastic", color = [0.9, 0.3, 0.06], roughness = 0.25) sphere(8);

// A board whose slot is cut by a moving cutter.
material("plastic", color = [0.1, 0.36, 0.56], roughness = 0.35) difference() {
    translate([30, 2, 0]) cube([50, 5, 62]);
    moving(translate = [14, 0, 0]) translate([38, 0, 12]) cube([8, 10, 38]);
}
material("matte", color = [0.75, 0.73, 0.7]) translate([-900, -900, -2]) cube([1800, 1800, 2]);

sun(direction = [0.55, 0.6, -1], irradiance = 2.6, angle = 3, color = [1, 0.96, 0.9]);
environment(color = [0.5, 0.58, 0.68]);
camera(eye = [6, -190, 66], target = [10, 0, 30], fov = 32);
