// Across types nothing is equal, and nothing is said.
echo(1 == "1", true == 1, undef == false, undef == undef, 0 == false, [] == undef, "" == []);
nan = 0 / 0;
echo(nan == nan, [nan] == [nan], nan != nan, -0 == 0);
echo([1, [2, "x"]] == [1, [2, "x"]], [1, 2] == [1, 2, 3], [0:1] == [0:1:1], [0:2] == [0:1]);
