// a line
/* a
 block * / // */ echo("after"); // tail
echo(/* inside */ 1 /**/ + 2);
cube(1) /* child */ ;
