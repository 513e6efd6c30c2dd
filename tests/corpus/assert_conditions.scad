a = 3; assert(a > 2 && [1, 2][0] == 1, str("a is ", a));
assert(condition = true, message = "m");
assert(true) cube(1);
assert(is_num(a)) { cube(2); sphere(1); }
module m(x) { assert(x != 2 || x == (1 + 1) * 1, "never"); assert(x < 2, ["list", x]); } m(1); m(2);
