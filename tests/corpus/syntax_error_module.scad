module 3() cube(); module (a) cube();
