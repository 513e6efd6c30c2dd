use <cycle_b.scad>
function from_a(n) = n > 3 ? n : from_b(n+1);
