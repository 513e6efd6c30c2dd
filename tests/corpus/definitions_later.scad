cube(side());
m(2);
function side() = 3;
module m(x) { sphere(x); }
module m(x) { cylinder(x); }
function side() = 4;
