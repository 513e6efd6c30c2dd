module a() { b() children(); } module b() { echo(parent_module(), parent_module(0), parent_module(1), $parent_modules); children(); }
a() echo(parent_module(0), parent_module(1), $parent_modules);
b();
module c() { echo(parent_module(5)); echo(parent_module(-1)); echo(parent_module("x")); echo(parent_module(0.9)); } c();
echo(parent_module());
