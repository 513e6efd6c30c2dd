echo(len([for (i = [0 : 99999]) i]));
echo([for (i = [0 : 1e6]) i]);
echo([for (i = [0 : 1 : 1/0]) i]);
echo([for (i = [0 : 0 : 5]) i]);
echo(len([each [0 : 5000]]));
