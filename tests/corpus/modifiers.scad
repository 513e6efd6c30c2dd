%cube(1);
#sphere(1);
*cylinder(1);
union() { %cube(2); #cube(3); *cube(4); cube(5); }
%#cube(6);
#if (true) cube(7);
%for (i=[0:1]) cube(i);
*echo("never");
