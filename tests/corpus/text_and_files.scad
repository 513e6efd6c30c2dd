text("hi"); text("a b", size=5, font="Liberation Sans:style=Bold", halign="center", valign="top", spacing=1.5, direction="rtl", language="de", script="latin", $fn=12); text(t="x"); text("x", 7, "f");
import("no.stl"); import(file="no.dxf", layer="l", convexity=3, origin=[1,2], scale=2);
surface("no.dat"); surface(file="no.png", center=true, invert=true, convexity=5);
