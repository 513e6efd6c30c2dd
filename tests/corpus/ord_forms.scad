echo(ord("A"), ord("ABC"), ord("€"), ord("😀"), ord(""), ord(5), ord(), ord("a", "b"), ord(undef));
