echo(search("a","abcdabcd"), search("e","abcdabcd"), search("a","abcdabcd",0), search("abe","abcdabcd",0), search("abe","abcdabcd"), search("abe","abcdabcd",2));
data = [["a",1],["b",2],["c",3],["d",4],["a",5],["b",6],["c",7],["d",8],["e",3]];
echo(search("a",data), search("a",data,0), search("abc",data,0), search(["a","z"],data), search(["a","z"],data,0), search([3],data,0,1), search([3],data,0), search(3,data,0,1));
echo(search(1,[1,2,1],0), search([1,9],[1,2]), search([[1,3]],[[1,3],[3,4]]), search([], [1]), search(true,[true]), search(undef,[1]));
