for (i=[0:2]) translate([i*2,0,0]) cube(1);
for (i=[1,5], j=["a","b"]) echo(i, j);
for (c="xyz") echo(c);
for (x=5) echo(x);
for (x=undef) echo(x);
for (x=[]) echo(x);
for (v=[[1,2],[3,4]]) echo(v[0], v[1]);
for (i=[0:9999]) cube(i);
for (i=[0:-1:5]) echo(i);
