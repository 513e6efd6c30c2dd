module m() { echo($children); n(); } module n() { echo($children); }
m() { cube(); sphere(); }
m();
m() { for (i = [0 : 2]) cube(i); if (true) sphere(); ; { } }
