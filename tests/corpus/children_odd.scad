module each_of() { echo($children); for (i = [0 : 1 : $children - 1]) children(i); }
each_of() { cube(1); sphere(2); for (i = [0 : 2]) translate([i, 0]) square(i + 1); if (false) cube(3); if (true) { cube(4); cube(5); } ; { } echo("x"); union() {} }
module pick() { children([0, 2]); children([2 : -1 : 0]); children(1.9); children(-1); children(99); children("a"); children(undef); children([0, "a", 7]); children([]); children([1 : 0 : 2]); children(true); children(0, 1); children(index = 1); }
pick() { cube(1); cube(2); cube(3); }
module none() { children(); children(0); echo($children); } none(); none() { } none();
module outer2() { echo(parent_module(0), parent_module(1), parent_module(2), parent_module(-1), parent_module(99), parent_module("a"), $parent_modules); middle() children(); }
module middle() { echo(parent_module(0), parent_module(1), parent_module(2), $parent_modules); children(); }
outer2() middle(); echo($parent_modules, parent_module(), parent_module(0));
module rec(n) { if (n > 0) rec(n - 1) { children(); cube(n); } else children(); }
rec(3) sphere(9);
module scope() { x = 5; $y = 6; children(); } x = 1; $y = 2; scope() echo(x, $y); scope() { x = 9; echo(x, $y); }
module swap() { children(1); children(0); } swap() { swap() { cube(1); cube(2); } swap() { cube(3); cube(4); } }
union() { children(); } cube() sphere(); echo() cube(6); let (a = 4) { cube(a); sphere(a); } 
child(0); module oldchild() { child(); child(1); } oldchild() { cube(1); cube(2); }
render(convexity = 3) { cube(); } render() ; group() { cube(7); } hull() { } hull() cube(); minkowski() { } minkowski() cube(8); difference() { } intersection() { if (false) cube(); cube(9); }
