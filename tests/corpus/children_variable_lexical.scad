// $children is a variable of the module that is lexically around, not of the caller.
module inner() echo("inner", $children);
module outer() { inner(); inner() { cube(); sphere(); } function count() = $children; echo("outer", $children, count()); children(); }
outer() { inner(); inner() cube(); }
echo($children);
