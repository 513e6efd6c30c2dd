echo("abc"=="abc", "a"!="b", "b">"a", "ab"<"b", "Z"<"a", len(""), "äb"[0], "äb"[1], str("a","b")[1], "a"=="\x61", [for(c="äö") ord(c)]);
