// s2.pov — S2 by hand: a plate less 100 counterbored holes, as one would write it for POV-Ray. The camera is that of bench/ray_sets.cpp.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
background { rgb 0.26 }
#declare Towards = vnormalize(<0.35, -0.9, 1.3>);
#declare Right = vnormalize(vcross(-Towards, z));
#declare Height = 2 * tan(radians(10.5));
camera {
    perspective
    location Towards * 5.75 / sin(radians(20))
    direction -Towards
    right Right * Height * 4 / 3
    up vcross(Right, -Towards) * Height
}
difference {
    box { <-5, -5, -0.5>, <5, 5, 0.5> }
    #for (I, 0, 9)
        #for (J, 0, 9)
            cylinder { <I - 4.5, J - 4.5, -0.6>, <I - 4.5, J - 4.5, 0.2>, 0.3 }
            cylinder { <I - 4.5, J - 4.5, 0.2>, <I - 4.5, J - 4.5, 0.6>, 0.42 }
        #end
    #end
    pigment { rgb <0.95, 0.84, 0.17> }
}
