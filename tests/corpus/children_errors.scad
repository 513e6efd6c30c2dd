module a() children(5); module b() children(-1); module c() children("x"); module d() children(undef); module e() children([0, "y", 9]); module f() children(true); module g() children([0 : 20000]);
a() cube(); b() cube(); c() cube(); d() cube(); e() cube(); f() cube(); g() cube();
