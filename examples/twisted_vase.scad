// A twisted vase: the sides of a star sweep true helical surfaces, which no number of slices would give.
points = 8;
tip_r = 20;
notch_r = 15;
height = 60;
twist = 90;     // degrees, clockwise on the way up
flare = 1.3;    // how much wider the rim is than the foot
wall = 2;

module star(inset)
    polygon([for (i = [0 : 2 * points - 1])
        let(r = (i % 2 == 0 ? tip_r : notch_r) - inset, a = 180 * i / points) [r * cos(a), r * sin(a)]]);
module vessel(inset) linear_extrude(height, twist = twist, scale = flare) star(inset);

color("cadetblue") difference() {
    vessel(0);
    translate([0, 0, wall]) vessel(wall);  // as much lower as it is thick
}

// A star of n tips has the area n R r sin(180/n); a twist changes no section's area, the flare makes it grow with its square.
// fact: volume = 18526.934446126; 8 sin(22.5) (20 15 60 (1 + k + k^2)/3 - 18 13 60/(3 (k - 1)) ((1 + (k - 1) 58/60)^3 - 1)), k = 1.3
// fact: genus = 0; a vessel is a bent plate
// fact: components = 1; one skin
// perturb: wall = 2.05
