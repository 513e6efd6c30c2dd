module n() echo($children);
n(); n() cube(); n() { cube(); cube(); } n() { } n() ; n() { if (false) cube(); } n() { a = 1; } n() for (i = [0 : 3]) cube(); n() *cube(); n() { *cube(); sphere(); }
