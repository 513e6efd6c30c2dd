// Modules of old names.
import_stl("missing.stl");
import_off("missing.off", convexity = 2);
import_dxf("missing.dxf", layer = "0");
dxf_linear_extrude(height = 3) square(2);
dxf_rotate_extrude() square(2);
color("#12345680") cube(1);
color("#1238") cube(2);
