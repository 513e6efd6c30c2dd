module m() { include <lib/snippet.scad>
 echo(inner); }
m();
union() { include <lib/shape.scad>
}
