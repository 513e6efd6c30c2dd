// line
/* block
 * over lines */ echo(1); /* /* no nesting */ echo(2); // end
echo(/* inside */ 3); /**/ echo(4); /***/ echo(5);
echo(6 // trailing
);
