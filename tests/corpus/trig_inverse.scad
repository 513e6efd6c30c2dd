echo([for (x = [-1 : 0.25 : 1]) asin(x)], [for (x = [-1 : 0.25 : 1]) acos(x)], [for (x = [-3 : 3]) atan(x)]);
echo(asin(2), acos(-2), atan(1/0), atan2(0, 0), atan2(0, -1), atan2(-0, -1), atan2(1, 0), atan2(-1, 0), atan2(3, 4), atan2(1, sqrt(3)));
echo([for (d = [0 : 7 : 90]) asin(sin(d)) == d], [for (d = [0 : 7 : 90]) atan(tan(d)) == d]);
