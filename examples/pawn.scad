// A chess pawn: one profile, turned about its axis; the mouldings are half rings, the head is a ball.
head_r = 6;
head_z = 29;

module profile() {
    polygon([[0, 0], [11, 0], [11, 3], [9.5, 5], [6.5, 8], [4.2, 13], [3.4, 19], [3.6, 22], [5, 23], [5, 24.5], [0, 24.5]]);
    translate([9.5, 5]) circle(1.5);   // moulding of the foot
    translate([5, 23.75]) circle(0.75);  // collar
}

color("wheat") {
    rotate_extrude() profile();
    translate([0, 0, head_z]) sphere(head_r);
}

// fact: volume = 4560.14366852 within 1e-6; Pappus: the profile's moment by quadrature, and the ball above the collar
// fact: genus = 0; a body of revolution that meets its axis
// fact: components = 1; one skin
// perturb: head_r = 6.05
