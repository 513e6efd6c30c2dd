use <lib/cycle_a.scad>
echo(from_a(1));
