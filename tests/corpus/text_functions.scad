echo(str("a","b"), str(1,2), str([1,"a"]), str(1e10,-5), chr(65), chr([72,105]), chr([65:70]), chr(65,66,"x",67), chr(228), chr(0), chr(-5), chr(128512), chr(55296), chr(1e9));
echo(ord("A"), ord("ä"), ord("abc"), ord(""), len("ä€😀"), [for (c="ä€") ord(c)]);
echo(concat([1],[2,[3]],4), concat(), concat("a"), concat([],[]), concat([1,2],[for (i=[3:4]) i]));
