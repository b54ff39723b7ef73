-- For any database; see docs/databases.md.
create table account (
  id integer primary key /*! auto_increment */,
  holder varchar(40) not null unique,
  balance integer not null check (balance >= 0),
  rate double,
  opened varchar(10)
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;
