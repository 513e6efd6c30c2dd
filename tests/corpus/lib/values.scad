size = 4;
function size_twice() = size * 2;
module marker() echo("marker", size, $shared);
echo("top of the library");
cube(size);
