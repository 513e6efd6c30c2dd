// An involute spur gear, its teeth computed here: no library.
teeth = 18;
modul = 2;           // pitch diameter / teeth
pressure_angle = 20;
thickness = 8;
bore_d = 10;
steps = 8;           // points on each flank

pitch_r = modul * teeth / 2;
base_r = pitch_r * cos(pressure_angle);
tip_r = pitch_r + modul;
root_r = pitch_r - 1.25 * modul;

// Angle by which the involute of the base circle has turned at radius r: tan(a) - a, in degrees.
function turned(r) = let(a = acos(base_r / r)) tan(a) * 180 / PI - a;
function polar(r, angle) = [r * cos(angle), r * sin(angle)];

half_tooth = 90 / teeth + turned(pitch_r);  // angle from the middle of a tooth to the foot of its flank
flank = [for (i = [0 : steps]) let(r = base_r + (tip_r - base_r) * i / steps) [r, half_tooth - turned(r)]];

tooth = concat(
    [polar(root_r, -half_tooth)],
    [for (p = flank) polar(p[0], -p[1])],
    [for (i = [steps : -1 : 0]) polar(flank[i][0], flank[i][1])],
    [polar(root_r, half_tooth)]
);
outline = [for (k = [0 : teeth - 1], p = tooth)
    let(a = 360 * k / teeth) [p.x * cos(a) - p.y * sin(a), p.x * sin(a) + p.y * cos(a)]];

color("darkorange") difference() {
    linear_extrude(thickness) polygon(outline);
    cylinder(h = thickness, d = bore_d);
    translate([-1.5, 0, 0]) cube([3, bore_d / 2 + 1.4, thickness]);  // keyway
    for (i = [0 : 5]) rotate([0, 0, 60 * i + 30]) translate([10.4, 0, 0]) cylinder(h = thickness, d = 5);
}

// fact: volume = 6297.39657879; (shoelace of the outline - six holes - bore and keyway) times the thickness
// fact: area = 4501.16881763; twice that face, and its perimeter times the thickness
// fact: genus = 7; the bore with its keyway, and six holes
// fact: components = 1; one skin
// perturb: thickness = 8.05
