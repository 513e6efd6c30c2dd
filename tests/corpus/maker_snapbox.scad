// A box with a lid that snaps: walls, posts, vents, a label; everything set at the top.
/* [Board] */
board = [70, 50, 1.6];
holes = [[4, 4], [66, 4], [4, 46], [66, 46]];
/* [Case] */
wall = 2; // [1:0.2:4]
inside = 22; // inner height
gap = 0.3;
corner = 4; // [0:10]
part = "both"; // [base, lid, both, section]
label = "λ-Box №7";
vents = true;
connectors = [ // side, position, width, height, z
    ["front", 12, 9, 4, 3], ["front", 40, 15, 7, 2], ["left", 20, 12, 11, 4], ["back", 35, 6, 6, 8]];
/* [Hidden] */
$fn = 24;
outer = [board.x + 2 * (wall + gap), board.y + 2 * (wall + gap), inside + wall];
module rounded(size, r) {
    if (r > 0) hull() for (x = [r, size.x - r], y = [r, size.y - r]) translate([x, y, 0]) cylinder(r = r, h = size.z);
    else cube(size);
}
module shell(size, r, t) difference() { rounded(size, r); translate([t, t, t]) rounded([size.x - 2 * t, size.y - 2 * t, size.z], max(0, r - t)); }
module on_side(side) {
    if (side == "front") children();
    else if (side == "back") translate([outer.x, outer.y, 0]) rotate(180) children();
    else if (side == "left") translate([0, outer.y, 0]) rotate(-90) children();
    else if (side == "right") translate([outer.x, 0, 0]) rotate(90) children();
    else echo(str("unknown side ", side));
}
module opening(c) on_side(c[0]) translate([wall + gap + c[1] - c[2] / 2, -1, wall + c[4]]) cube([c[2], wall + 2, c[3]]);
module post(h, d = 6, hole = 2.5) difference() { cylinder(d = d, h = h); translate([0, 0, h / 4]) cylinder(d = hole, h = h); }
module at_holes() for (h = holes) translate([h.x + wall + gap, h.y + wall + gap, 0]) { $hole = h; children(); }
module grille(w, h, n) for (i = [0 : n - 1]) translate([i * w / n + w / n / 4, 0, 0]) cube([w / n / 2, h, wall * 3]);
module ridge(l) rotate([0, 90, 0]) cylinder(r = 0.6, h = l, center = true, $fn = 8);
module ridges(inset) {
    for (s = [-1, 1]) translate([outer.x / 2, outer.y / 2 + s * (outer.y / 2 - inset), 0]) ridge(outer.x * 0.6);
    for (s = [-1, 1]) translate([outer.x / 2 + s * (outer.x / 2 - inset), outer.y / 2, 0]) rotate(90) ridge(outer.y * 0.6);
}
module base() {
    difference() {
        shell(outer, corner, wall);
        for (c = connectors) opening(c);
        translate([0, 0, outer.z - 2]) ridges(wall);
        if (vents) translate([wall + 10, outer.y / 4, -wall]) grille(outer.x - 2 * wall - 20, outer.y / 2, 8);
    }
    translate([0, 0, wall]) at_holes() { post(4); echo(post = $hole); }
}
module lid() {
    t = wall + gap;
    difference() {
        union() {
            rounded([outer.x, outer.y, wall], corner);
            translate([t, t, 0]) shell([outer.x - 2 * t, outer.y - 2 * t, wall + 4], max(0, corner - t), wall * 0.8);
        }
        translate([outer.x / 2, outer.y / 2, -1]) mirror([1, 0, 0]) linear_extrude(1.5) text(label, size = 8, halign = "center", valign = "center", $fn = 4);
    }
    translate([0, 0, wall + 2]) ridges(t + 0.1);
}
if (part == "base" || part == "both") color("SteelBlue") base();
if (part == "lid" || part == "both") translate(part == "both" ? [0, outer.y + 10, 0] : [0, 0, 0]) color("tan", 0.8) lid();
if (part == "section") difference() { base(); translate([-1, outer.y / 2, -1]) cube(200); }
echo(outer = outer, volume = (outer.x - 2 * wall) * (outer.y - 2 * wall) * inside / 1000, len(label), [for (c = label) ord(c)]);
