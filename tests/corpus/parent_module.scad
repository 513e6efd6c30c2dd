module a() { b(); }
module b() { echo(parent_module(0), parent_module(1), parent_module(), $parent_modules); children(); }
a();
b() a();
echo(parent_module(0));
module c() children();
c() b();
echo(parent_module("x"), parent_module(-1));
