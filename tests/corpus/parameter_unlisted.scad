module usezz() { echo(zz); }
usezz(zz=4);
usezz();
function g() = zz;
echo(g(zz=8), g());
