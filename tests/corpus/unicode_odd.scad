s = "aß世😀e\u0301";
echo(len(s), s[2], s[3], s[9], [for (c = s) ord(c)], str(s[3], s[1]), chr(128512), chr([97, 19990, 223]), chr([97 : 100]), chr(-1), chr(0), chr(1114112), chr(1e9), chr("a"), chr(55296), chr(65, [66, 67]), chr());
echo(ord("😀"), ord(""), ord("ab"), ord(5), ord(), ord("a", "b"), len("\u00e9\U01F600"), "\x41\x7f\u20ac", "tab\tq\"uote\\ back", len("\n"), len("\x00"), "\xff");
echo(s < "b", "Z" < "a", "ß" > "z", "" < "a", "a" < "aa", "a" == "a", max("a", "b"), min(["b", "a"]), "a" + "b", "a" * 2, -"a", !"a", !"", "abc".x, "abc"[-1], "abc"[1.7], "abc"["a"], "abc"[undef], [for (i = [0 : 4]) "abc"[i]]);
echo(str(), str(1, "a", [1, "b", ["c"]], undef, true, 1e100, -0, 1 / 0, [0 : 2], function(x) x + 1), concat("a", ["b"], [["c"]], 1), concat(), len(5), len(), len([1, 2], 3), is_string(s), is_list("a"));
