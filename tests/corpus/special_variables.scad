echo($fn, $fa, $fs, $t, $preview, $vpr, $vpt, $vpd, $vpf);
$fn = 7;
echo($fn);
module m() { echo($children, $parent_modules); $fn = 3; sphere(1); }
m();
sphere(1);
sphere(1, $fn=12);
cylinder(1, $fa=30);
circle(2, $fs=0.5);
m() { cube(1); cube(2); }
