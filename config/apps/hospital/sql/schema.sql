-- The database of the hospital's guide: one schema for SQLite and MariaDB.
-- There are no patients in it, and nothing that somebody says is kept.

-- Floors: ground floor 0, basement -1. A place that never closes is open from
-- 00:00 to 24:00.
create table place (
  name   varchar(60)  primary key,
  kind   varchar(16)  not null,       -- ward, clinic, service
  floor  integer      not null,
  way    varchar(160) not null,       -- to be spoken: behind the main stairs
  opens  varchar(5)   not null,
  closes varchar(5)   not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- Days of the week: 1 is Monday.
create table visiting (
  id     integer primary key,
  ward   varchar(60) not null,        -- place.name
  days   varchar(7)  not null,
  opens  varchar(5)  not null,
  closes varchar(5)  not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table doctor (
  name       varchar(60) primary key, -- without the title
  title      varchar(8)  not null,
  department varchar(60) not null,    -- place.name
  days       varchar(7)  not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- What people come for, in a word or two, and who is there for it.
create table need (
  words      varchar(40) primary key,
  department varchar(60) not null     -- place.name
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table fact (
  thing  varchar(40)  primary key,
  answer varchar(255) not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table porter (
  id          integer primary key /*! auto_increment */,
  destination varchar(60) not null,
  help        varchar(20) not null,
  status      varchar(8)  not null    -- called
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;
