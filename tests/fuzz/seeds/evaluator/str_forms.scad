echo(str(), str("a"), str("a", "b"), str(1, 2), str("a", [1, "b"], undef), str([["x"]], "y"), str(true, [1:2]), str(str("q")), len(str("\"a")));
