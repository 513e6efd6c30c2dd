$mine = 10;
module show() echo($mine);
function mine() = $mine;
