echo(search("a", "abcabc"), search("a", "abcabc", 0), search("ac", "abcabc", 2), search("xyz", "abc"), search("", "abc"), search("é", "aéb"), search("aa", "aba", 0));
echo(search("b", [["a", 1], ["b", 2], ["b", 3]]), search("b", [["a", 1], ["b", 2], ["b", 3]], 0), search("ab", [["a", 1], ["b", 2]]), search("c", [["a", 1]]), search("a", ["a", "b"]), search("a", [[1, "a"], [2, "b"]], 1, 1));
