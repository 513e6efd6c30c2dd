// c1
echo(1); /* a /* b */ echo(2); // end
/**/echo(3);/* x
 y */ echo(4); //
