import("nowhere.stl"); import(file = "nowhere.off", convexity = 5); import("nowhere.dxf", layer = "a", origin = [1, 2], scale = 3); import("nowhere.svg", center = true, dpi = 96); import();
