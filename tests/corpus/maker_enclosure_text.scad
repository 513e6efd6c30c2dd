// Signs: text in all its parameters, cut and raised; a clock face; a ruler; a font of seven segments.
module sign(t, h = 10, font = "Liberation Sans:style=Bold", depth = 1) {
    difference() {
        linear_extrude(2) offset(3, $fn = 12) square([len(t) * h * 0.8, h * 1.6]);
        translate([len(t) * h * 0.4, h * 0.8, 2 - depth]) linear_extrude(depth + 1) text(t, size = h, font = font, halign = "center", valign = "center", $fn = 3);
    }
}
sign("Hello");
translate([0, 30, 0]) sign("Grüße, 世", 8, "Liberation Serif");
translate([0, 60, 0]) for (i = [0 : 2]) translate([0, 15 * i, 0]) linear_extrude(1) text(["left", "center", "right"][i], halign = ["left", "center", "right"][i], valign = ["top", "baseline", "bottom"][i], size = 7 + i, spacing = 1 + i / 4, $fn = 2);
module ruler(cm) {
    cube([cm * 10, 20, 2]);
    for (i = [0 : cm * 10]) translate([i, 0, 2]) { l = i % 10 == 0 ? 10 : i % 5 == 0 ? 7 : 4; cube([0.3, l, 0.4]); if (i % 10 == 0) translate([0.5, 11, 0]) linear_extrude(0.4) text(str(i / 10), size = 5, $fn = 1); }
}
translate([0, -40, 0]) ruler(4);
segments = [[1, 1, 1, 0, 1, 1, 1], [0, 0, 1, 0, 0, 1, 0], [1, 0, 1, 1, 1, 0, 1], [1, 0, 1, 1, 0, 1, 1], [0, 1, 1, 1, 0, 1, 0], [1, 1, 0, 1, 0, 1, 1], [1, 1, 0, 1, 1, 1, 1], [1, 0, 1, 0, 0, 1, 0], [1, 1, 1, 1, 1, 1, 1], [1, 1, 1, 1, 0, 1, 1]];
place = [[0, 2, 0], [0, 1, 90], [1, 1, 90], [0, 1, 0], [0, 0, 90], [1, 0, 90], [0, 0, 0]];
module digit(n, s = 6) for (k = [0 : 6]) if (segments[n][k]) translate([place[k][0] * s, place[k][1] * s]) rotate(place[k][2]) translate([s * 0.1, -0.5]) square([s * 0.8, 1]);
function digits_of(n) = n < 10 ? [n] : concat(digits_of(floor(n / 10)), [n % 10]);
module number(n) for (i = [0 : len(digits_of(n)) - 1]) translate([i * 9, 0]) digit(digits_of(n)[i]);
translate([70, 0, 0]) linear_extrude(1.5) number(1048576 / 4 + 90);
echo(digits_of(90210), len("Grüße, 世"), [for (c = "aß世") [c, ord(c), chr(ord(c) + 1)]], search("l", "Hello", 0), str("a", 1, true, undef, [1, "b"], [0 : 2]));
