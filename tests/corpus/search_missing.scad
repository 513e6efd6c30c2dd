data = [["a",1],["b",2]];
echo(search("z",data));
echo(search("az",data,0));
echo(search("a",["ab","cd"]));
echo(search("x",[["x",1]],1,5));
echo(search("a",5));
