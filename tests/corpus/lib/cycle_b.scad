use <cycle_a.scad>
function from_b(n) = n > 3 ? -n : from_a(n+1);
