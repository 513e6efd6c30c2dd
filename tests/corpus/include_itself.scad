// A file that includes itself is read once more; then it counts as missing.
echo("once more");
include <include_itself.scad>
echo("end");
