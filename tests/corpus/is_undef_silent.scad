// is_undef(name) of an unknown name says nothing; any other use does.
echo(is_undef(nobody), is_undef($nobody), is_undef(undef), is_undef(0));
echo(is_undef(nobody + 1));
echo(is_undef([nobody]));
x = nobody;
echo(is_undef(x));
function f(a) = is_undef(a) ? "none" : a;
echo(f(), f(3), f(undef));
