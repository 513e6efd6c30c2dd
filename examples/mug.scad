// A mug of abutting solids: floor, wall and handle only touch, and yet there is no seam between them.
outer_r = 30;
wall = 4;
height = 70;
floor_h = 6;
handle_r = 18;      // of the handle's bend
handle_tube = 5;

module floor_disc() cylinder(h = floor_h, r = outer_r);

module wall_tube() translate([0, 0, floor_h]) difference() {
    cylinder(h = height - floor_h, r = outer_r);
    cylinder(h = height - floor_h, r = outer_r - wall);
}

// A round bar from the wall's middle, a half ring, and a bar back.
module handle() difference() {
    union() {
        for (z = [-handle_r, handle_r])
            translate([0, 0, z]) rotate([0, 90, 0]) cylinder(h = outer_r + 6, r = handle_tube);
        translate([outer_r + 6, 0, 0]) rotate([90, 0, 0]) rotate([0, 0, -90])
            rotate_extrude(angle = 180) translate([handle_r, 0]) circle(handle_tube);
    }
    cylinder(h = 2 * height, r = outer_r, center = true);  // flush with the outside of the wall
}

color("steelblue") {
    floor_disc();
    wall_tube();
    translate([0, 0, height / 2 + 2]) handle();
}

// fact: volume = 67402.6921629 within 1e-8; cylinders, the half ring by Pappus, and bars cut by the wall: 2 integrals of sqrt(R^2 - y^2) over a disc
// fact: genus = 1; the handle
// fact: components = 1; the parts touch in whole faces, so they are one
// perturb: handle_tube = 5.2
