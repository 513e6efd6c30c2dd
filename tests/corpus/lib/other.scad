use <parts.scad>
function volume(s) = str("other ", s);
module both() { peg(5); echo(volume(1)); }
