module a() { x = 1; module b() { echo(x); x2 = x; echo(x2); } x = 2; b(); } a(); if (true) { y = 3; module_var = y; echo(module_var); } echo(y);
