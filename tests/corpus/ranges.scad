r = [1:2:9];
echo(r, [0:3], [3:-1:0], r[0], r[1], r[2], r[3], r.begin, r.step, r.end, r.foo, len([1,2]));
echo([for (i=r) i], [for (i=[0:0.1:0.5]) i], [for (i=[3:-1:0]) i], [for (i=[2:2]) i], [for (i=[0:5:3]) i]);
echo([for (i=[0:1/0]) i]);
echo([for (i=[0:0:1]) i]);
echo([for (i=[0:1/0:1]) i]);
echo([0:"a"], ["a":1], [0:"s":1], [undef:1]);
