module m() { echo($children); children(0); children([1,0]); children([0:1]); children(-1); children(5); children(1.7); children("a"); } m() { cube(1); sphere(2); }
