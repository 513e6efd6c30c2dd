y = z * 2; z = 4; echo(y, z);
