union(1) cube(); difference(a = 2) cube(); hull(3) cube(); intersection(x = 1) cube(); group(1) cube(); render(a = 1) cube();
