echo([for (a=[0:30:360]) sin(a)], [for (a=[0:30:360]) cos(a)], [for (a=[0:45:360]) tan(a)]);
echo(sin(-30), cos(-60), sin(390), cos(420), tan(-45), tan(89.9), sin(1), cos(1), tan(1), sin(0.001), sin(1e10), sin(1/0), cos(0/0));
echo(asin(0.5), asin(1), asin(-1), acos(0.5), acos(0), acos(2), atan(1), atan(-1), atan(1e10), atan2(1,1), atan2(-1,-1), atan2(0,-1), atan2(1,2), asin(0.1));
echo(sin(30)==0.5, cos(60)==0.5, sin(45)==sqrt(0.5), sin(180)==0, tan(45)==1, cos(90)==0);
