// whittle.scad — Whittle's additions to the language, in plain OpenSCAD terms, so that one scene opens in both programs.
//
//     include <whittle.scad>
//
// Whittle knows these modules itself and reads this file as an empty one. OpenSCAD shows a stand-in: facets for true curves, colours for materials,
// nothing for lights and cameras. The file holds modules only: a variable here would leak into the scenes that include it.

// Ring of radius r1 about z with a tube of radius r2; r2 > r1 is the spindle, filled.
module torus(r1 = 1, r2 = 0.5, d1, d2) {
    major = is_undef(d1) ? r1 : d1 / 2;
    minor = is_undef(d2) ? r2 : d2 / 2;
    rotate_extrude($fn = $fn == 0 ? 72 : $fn) intersection() {
        translate([major, 0]) circle(minor, $fn = $fn == 0 ? 48 : $fn);
        translate([0, -minor]) square([major + minor, 2 * minor]);
    }
}

module ellipsoid(r = [1, 1, 1]) scale(r) sphere(1, $fn = $fn == 0 ? 72 : $fn);

// Points with n.p <= d. Here: a cube that is large against d.
module halfspace(n = [0, 0, 1], d = 0) {
    length = norm(n);
    edge = max(2000, 20 * abs(d) / length);
    rotate([0, acos(n[2] / length), atan2(n[1], n[0])]) translate([-edge / 2, -edge / 2, d / length - edge]) cube(edge);
}

module quadric(c) echo("quadric() cannot be shown here: open the scene in Whittle");

// A sphere of radius r swept from p to q.
module capsule(p = [0, 0, 0], q = [0, 0, 1], r = 1) hull() {
    translate(p) sphere(r, $fn = $fn == 0 ? 48 : $fn);
    translate(q) sphere(r, $fn = $fn == 0 ? 48 : $fn);
}

// A box whose edges and corners are rounded by r.
module roundcube(size = [1, 1, 1], r = 0, center = false) {
    edges = is_num(size) ? [size, size, size] : size;
    translate(center ? -edges / 2 : [0, 0, 0])
        if (r > 0) hull() {
            for (x = [r, edges[0] - r], y = [r, edges[1] - r], z = [r, edges[2] - r]) translate([x, y, z]) sphere(r, $fn = $fn == 0 ? 48 : $fn);
        } else {
            cube(edges);
        }
}

// A named part: one object of an export.
module part(name) children();

// A material is its colour here.
module material(preset, color, roughness, metal, ior, transmission, absorption, dispersion, emission, priority) {
    if (!is_undef(color)) color(color) children();
    else if (preset == "glass") color([0.75, 0.9, 0.95, 0.35]) children();
    else if (preset == "water") color([0.55, 0.75, 0.95, 0.4]) children();
    else if (preset == "diamond") color([0.9, 0.97, 1, 0.4]) children();
    else if (preset == "mirror") color([0.9, 0.9, 0.92]) children();
    else if (preset == "gold") color([1, 0.78, 0.34]) children();
    else if (preset == "silver") color([0.95, 0.93, 0.88]) children();
    else if (preset == "copper") color([0.95, 0.64, 0.54]) children();
    else if (preset == "steel") color([0.62, 0.64, 0.67]) children();
    else if (preset == "brushed") color([0.72, 0.73, 0.75]) children();
    else if (preset == "emissive") color([1, 0.97, 0.85]) children();
    else children();
}

// What light, lens and time say has no meaning here: nothing is drawn, and moving parts stand where they start.
module light(p, color, power, r) {}
module sun(direction, color, irradiance, angle) {}
module area_light(p, u, v, color, power) {}
module environment(color, intensity, rotate, file) {}
module camera(eye, target, up, fov, aperture, focus, projection, exposure, blades) {}
module moving(translate, rotate, scale) children();
