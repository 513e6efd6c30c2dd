echo("never closed);
cube(1);
