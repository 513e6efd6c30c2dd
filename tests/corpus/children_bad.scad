module m() { children(5); children(-1); children("a"); children([0,"b"]); children(undef); }
m() { cube(1); }
children();
child();
