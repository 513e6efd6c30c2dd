use <lib/dynamic.scad>
show(); $mine = 1; show(); show($mine = 2); echo(mine());
