module m() {
  cube(1);
