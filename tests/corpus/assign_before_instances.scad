echo(late);
cube(late);
late = 3;
