*cube(1); sphere(1); *echo("never"); *assert(false); *foo(); *translate([1, 0, 0]) cube(echo("no") 1); union() { *cube(2); sphere(2); }
*if (true) cube(3); *for (i = [0 : 1]) cube(i);
