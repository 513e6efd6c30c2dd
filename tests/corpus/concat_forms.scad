echo(concat(), concat(1), concat([1], [2]), concat([1], 2), concat([[1]], [2]), concat("a", "b"), concat([1, 2], [], [3]), concat(undef, [undef]), concat([0 : 2], [1]), concat(true));
