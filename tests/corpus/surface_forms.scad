surface("nowhere.dat"); surface(file = "nowhere.png", center = true, invert = true, convexity = 5);
