module outer(x) {
  y = x * 2;
  function twice(n) = n * 2 + y;
  module inner(z) { echo("inner", x, y, z, twice(z)); children(); }
  inner(1) inner(2);
  inner(y);
}
outer(5);
inner(3);
