module m() { use <lib.scad> cube(); }
m();
