echo(len([]), len([1, 2]), len(""), len("abc"), len("äöü€😀"), len([[1, 2], [3]]), len(5), len(undef), len(true), len(), len([1], [2]), len([0 : 3]));
