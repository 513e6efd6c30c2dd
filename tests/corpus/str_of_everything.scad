echo(str(1/3), str([1/3]), str("a\"b"), ["a\"b"], str(["a","b"]), str([]), str(undef), str(1e10), str(-0), str(0/0), str(true, false), len(str(1,2)), str(function(x) x), str([1:2]));
