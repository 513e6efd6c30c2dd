include <nowhere.scad>
cube(1);
use <nowhere_either.scad>
echo("goes on");
