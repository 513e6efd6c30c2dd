echo(version(), version_num(), version(1), version_num(1));
