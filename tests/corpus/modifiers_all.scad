*cube(1); %sphere(1); #cube(2); !cylinder(); ! *cube(5); #%cube(7); if(true) !cube(3);
