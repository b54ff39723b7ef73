insert into staff values ('Jeffery Ho'), ('Siti Aminah');
