thickness = 3;
width = 30;
depth = width * 0.75;
unit = "inch";
module unused() { sphere(undefined_name); }
