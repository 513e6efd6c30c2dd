// Modules with parameters, children, special variables and conditions.
module leaf(size) cube(size);
module branch(n, length) {
    width = length / 10;
    cylinder(r = width, h = length);
    if (n > 0) for (a = [0 : 120 : 359]) translate([0, 0, length]) rotate([30, 0, a]) branch(n - 1, length * 0.7);
    else leaf(width);
}
module ring(n) for (i = [0 : n - 1]) rotate(i * 360 / n) translate([10, 0]) let ($index = i) children();
branch(8, 100);
ring(2000) ring(10) sphere(r = $index, $fn = 8);
