square(); square(2); square([1, 2]); square([1, 2], true); square(center = true); square(0); square(-1); square("a"); square([1]); square([1, "b"]); square([1, 2, 3]); square(1/0);
