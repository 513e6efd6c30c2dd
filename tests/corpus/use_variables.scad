use <lib/values.scad>
marker(); echo(size_twice()); echo(is_undef(size)); $shared = 5; marker(); echo(size_twice($shared = 6));
