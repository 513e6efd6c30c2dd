translate([1,0,0]) {
  function f() = 1;
  cube(1);
}
