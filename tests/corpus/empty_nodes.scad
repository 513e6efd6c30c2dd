assert(true) echo("a");
assert(true) {}
echo("b") {}
echo("c") if(false) cube();
assert(true) let(a=1);
let(a=1);
union() if(false) cube();
if(true) if(false) cube();
if(true);
for(i=[0:1]);
module z(){}
z();
z(){cube();}
module zz() echo("p");
zz();
translate([1,0,0]);
color("red");
linear_extrude(3);
intersection_for(i=[]) cube();
intersection_for(i=[0:2]);
