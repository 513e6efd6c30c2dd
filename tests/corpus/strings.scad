echo("abc"[0], "abc"[2], "abc"[3], "äöü"[1], len("äöü"), "tab\there", "quote\"q", "back\\slash", "\x41\u00e4\U01f600");
echo("line\nbreak", str("a", 1, true, undef, [1,"b"], [0:2]), str(), str("x"));
echo("multi
line");
echo("a" == "a", "abc" < "abd", "" == "");
