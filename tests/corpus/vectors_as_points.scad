points = [for (i=[0:5]) [cos(i*60)*10, sin(i*60)*10]];
echo(points);
polygon(points);
linear_extrude(2) polygon([for (a=[0:45:315]) 5*[cos(a),sin(a)]]);
