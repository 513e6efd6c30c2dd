// Code points, not bytes.
s = "aäb😀c";
echo(len(s), s[1], s[3], s[4], s[5], s[-1], s["x"], s[1.9]);
echo([for (c = s) ord(c)]);
echo(chr(228), chr([104, 105]), chr([97:100]), chr(0), chr(-5), chr("a"), chr(1114112), chr(55296));
echo(str("a", 1, [1, "b"], undef, true, [0:2]), str(), str([]));
