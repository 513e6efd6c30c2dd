// Children see the caller's variables and the current $-variables.
v = "file";
$d = "file $";
module wrap() { v = "module"; $d = "module $"; echo(v, $d); children(); }
module show() echo(v, $d);
wrap() { show(); echo(v, $d); }
wrap() wrap() echo(v, $d);
module again() { for (i = [0:1]) let ($d = i) children(); }
again() echo($d, i = 5);
