%cube(1); sphere(1); difference() { cube(3); %sphere(2); sphere(1); } %union() { cube(1); #sphere(1); } %if (true) cube(4);
