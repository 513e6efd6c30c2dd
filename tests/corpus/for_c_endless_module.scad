echo("start");
x = [for (i = 0; true; i = i) 1];
echo("end");
