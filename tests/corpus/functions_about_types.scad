echo(is_undef(nope), is_undef(1), is_bool(true), is_num(0/0), is_num(1), is_string("a"), is_list([]), is_list([0:1]), is_function(sin), is_undef(), is_num(1,2), version(), version_num());
