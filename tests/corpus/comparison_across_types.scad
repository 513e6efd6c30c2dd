echo(undef==undef, undef==false, 0==false, ""==[], "a"<"b", [1,2]<[1,3], [1,"a"]<[1,2], [1]<[1,0], [0:1]<[0:2], true>false, "a"<1, undef<1, [undef]<[1], function(x) x < function(x) x);
