// A weld-neck pipe flange: flange, cone and pipe abut; eight bolt holes, a raised face.
bore_r = 20;
pipe_r = 24;
hub_r = 32;
flange_r = 55;
flange_h = 12;
hub_h = 16;
pipe_h = 20;
face_r = 36;
face_h = 2;
bolts = 8;
bolt_r = 4.5;
bolt_circle = 44;

difference() {
    color("cadetblue") union() {
        translate([0, 0, -face_h]) cylinder(h = face_h, r = face_r);
        cylinder(h = flange_h, r = flange_r);
        translate([0, 0, flange_h]) cylinder(h = hub_h, r1 = hub_r, r2 = pipe_r);
        translate([0, 0, flange_h + hub_h]) cylinder(h = pipe_h, r = pipe_r);
    }
    color("gainsboro") translate([0, 0, -face_h]) cylinder(h = face_h + flange_h + hub_h + pipe_h, r = bore_r);
    color("gold") for (i = [0 : bolts - 1])
        rotate([0, 0, 360 * i / bolts + 22.5]) translate([bolt_circle, 0, 0]) cylinder(h = flange_h, r = bolt_r);
}

// fact: volume = 129111.080482; discs + cone frustum + pipe - bore - eight holes
// fact: area = 33827.9108545; steps, cone pi (r1 + r2) s, pipe, bore; a hole adds 2 pi r (h - r)
// fact: genus = 9; the bore and eight holes
// fact: components = 1; one skin
// perturb: hub_r = 32.3
