echo(is_undef(undef), is_bool(true), is_num(1), is_num(0/0), is_string("a"), is_list([1]), is_list([0:1]), is_function(function(x) x));
echo(is_undef(1), is_bool(1), is_num("1"), is_string(1), is_list("a"), is_function(1), is_undef([][0]));
echo(version(), version_num(), PI);
