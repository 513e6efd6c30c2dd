for (i=[0:9]) x(i);
module n() { y = zz1; }
for (i=[0:9]) n();
for (i=[0:2]) echo(zz2);
