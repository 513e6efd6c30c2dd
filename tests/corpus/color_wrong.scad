color([2, 0, 0]) cube();
color([-1, 0, 0]) cube();
color("#12") cube();
color("#xyz") cube();
color(5) cube();
color([1, "a", 0]) cube();
