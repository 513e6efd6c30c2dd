if (true) cube(1);
if (false) cube(2);
if (0) cube(3); else cube(4);
if ("a") { cube(5); cube(6); } else { cube(7); }
if (undef) cube(8); else if (1) cube(9); else cube(10);
if (true) { } else cube(11);
if (false) cube(12); else ;
union() { if (false) cube(13); cube(14); }
