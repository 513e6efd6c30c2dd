;;;
{}
{;}
{{ a = 3; }}
echo(a);
cube();;
