#%cube(1); %#sphere(1); *!cube(2); !#cube(3);
