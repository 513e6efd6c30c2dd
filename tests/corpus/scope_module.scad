g = 1;
module sh() { y = g; g = 2; echo(y, g); }
sh();
module late() { echo(w); w = 7; }
late();
echo(g);
function h() = gg;
gv = h();
gg = 5;
echo(gv, h());
