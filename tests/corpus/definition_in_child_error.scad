union() { module m() cube(); m(); }
