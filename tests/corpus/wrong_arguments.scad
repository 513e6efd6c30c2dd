echo(sin(), sin(1,2), sin("a"), abs([1]), len(1), len(), len([1:2]), max(), max([]), max("a",1), min("a"), norm(), norm("a"), norm([1,"a"]));
echo(pow(1), pow("a",1), log("a"), log(1,2,3), sqrt(undef), atan2(1), round(true), str);
echo(cross(1,2), cross([1,2,3]), cross([1,2,3],[1,2]), cross([1,2,3],[1,2,"a"]), cross([1,2,0/0],[1,2,3]), cross([1,2,1/0],[1,2,3]));
echo(is_undef(), is_num(1,2), ord(5), ord("ab",1), chr("a"), lookup("a",[[1,2]]), search(1), rands(1,2));
