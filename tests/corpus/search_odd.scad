t = [["a", 1], ["b", 2], ["c", 3], ["a", 4], ["ab", 5], [7, "a"], "x", 9];
echo(search("a", t), search("ab", t), search(["ab"], t), search("abz", t), search("a", t, 0), search("ab", t, 2), search(["a", "b", "q"], t, 0));
echo(search(7, t), search(9, t), search([9], t), search(1, t, 1, 1), search([1, 3], t, 1, 1), search("a", t, 0, 1), search("a", "banana"), search("an", "banana", 0), search("nz", "banana", 2));
echo(search(3, [1, 3, 3, 5]), search(3, [1, 3, 3, 5], 0), search(3, [1, 3, 3], 1), search([3, 4], [1, 3, 3, 4], 0), search([3, [4]], [[4], 3]), search([[1, 2]], [[1, 2], [3]]), search([], t), search("", t));
echo(search("ü", "aüü", 0), search("世a", "世界a世"), search(undef, t), search(true, [true]), search("a", undef), search("a", 5), search("a"), search());
echo(search("a", t, -1), search("a", t, 1.9), search("a", t, 1, 5), search([["a", 1]], t), search("a", ["a", "b"]), search(["a"], ["a", "b"]), search("aa", t));
echo(lookup(2, [[1, 10], [3, 30]]), lookup(0, [[1, 10], [3, 30]]), lookup(9, [[3, 30], [1, 10]]), lookup(1, []), lookup("a", [[1, 2]]), lookup(2, [[1, 1], ["x", 2], [3, 3]]), lookup(2, [[2, 5], [2, 6]]), lookup(1 / 0, [[1, 2], [2, 3]]), lookup(0 / 0, [[1, 2], [2, 3]]));
echo(rands(0, 1, 2, 42), rands(0, 1, 2, 42), rands(5, 5, 2, 1), rands(10, 0, 2, 3), rands(0, 1, 0, 1), rands(-1, 1, 3, -7), rands(0, 1, 2, 1.5), rands(0, 10, 2.9, 4), rands(0, 1, 2, 1e12), rands(0, 1, 2, 0), rands(0, 1, 1, 2147483647), rands(0, 1, 1, 2147483648));
echo(rands(0, 1, -1, 1), rands("a", 1, 1), rands(0, 1), rands(0, 1 / 0, 1, 1), rands(0, 0 / 0, 1, 1), rands(0, 1, 1, "s"), rands(0, 1, 1, undef));
