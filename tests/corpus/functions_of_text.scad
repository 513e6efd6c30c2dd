echo(str(), str("a",1,[1,"b"],true,undef,[0:1]), chr(65), chr(0), chr(-1), chr(1114112), chr([65,66]), chr(8364), ord("a"), ord(""), ord("€x"), ord(5), ord(), chr("a"));
