echo([for (a = [-360 : 30 : 720]) sin(a)]);
echo([for (a = [-360 : 30 : 720]) cos(a)]);
echo([for (a = [-90 : 15 : 90]) tan(a)]);
echo(sin(30) == 0.5, cos(60) == 0.5, tan(45) == 1, sin(180) == 0, cos(270) == 0, sin(1e15), cos(1e17), tan(270), tan(-90));
