// A drawing that is not there: no numbers, and a message.
echo(dxf_dim(file = "nowhere.dxf", name = "width"), dxf_dim(file = "measured.dxf", layer = "dims", name = "height"));
echo(dxf_dim(file = "nowhere.dxf", name = "width", scale = 2, origin = [1, 2]));
echo(dxf_cross(file = "nowhere.dxf", layer = "cross"), dxf_cross(file = "measured.dxf", layer = "cross", origin = [1, 1], scale = 3));
echo(dxf_dim(file = "nowhere.dxf", name = "nowhere"));
echo(dxf_cross(file = "nowhere.dxf", layer = "nowhere"));
