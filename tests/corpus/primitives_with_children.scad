cube() sphere(); sphere(1) { cube(); } square() circle(); polygon([[0, 0], [1, 0], [0, 1]]) cube(); text("a") cube(); cylinder() { } ; cube() { a = 1; }
