create table guest (name text);
insert into guest values ('Ada');
