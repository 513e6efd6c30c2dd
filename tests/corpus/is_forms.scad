f = function () 1;
for (x = [[undef], [true], [1], [0/0], ["s"], [[]], [[0:1]], [f]]) echo(is_undef(x[0]), is_bool(x[0]), is_num(x[0]), is_string(x[0]), is_list(x[0]), is_function(x[0]));
echo(is_undef(), is_undef(1, 2), is_num(), is_list([], []), is_undef(undef), is_undef(nothing), is_undef(nothing[0]), is_list(nothing));
