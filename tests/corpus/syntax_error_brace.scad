module m() { cube();
