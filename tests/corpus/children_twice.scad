module twice() { children(); translate([5, 0, 0]) children(); }
twice() cube(rands(0, 1, 1, 3)[0] > 2 ? 1 : 2);
module each_child() for (i = [0 : $children - 1]) { $n = i; children(i); }
each_child() { echo("first", $n); echo("second", $n); }
