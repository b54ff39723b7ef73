create table staff (name varchar(80) primary key);
