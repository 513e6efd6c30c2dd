module outer() { inner() { echo("in outer"); children(); } } module inner() { children(0); children(1); }
outer() echo("leaf");
module pass() children(); pass() pass() pass() cube(3);
