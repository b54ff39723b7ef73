-- The database of the hotel: one schema for SQLite and MariaDB.
-- Dates and times are texts: 2026-11-21, 06:30. `/*! … */` is for MariaDB only.

create table room (
  number   integer primary key,
  floor    integer     not null,
  kind     varchar(16) not null,   -- single, double, family, suite
  occupied integer     not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table booking (
  number     integer primary key,  -- four digits
  surname    varchar(40) not null,
  first_name varchar(40) not null,
  kind       varchar(16) not null,
  arrival    varchar(10) not null,
  departure  varchar(10) not null,
  breakfast  integer     not null,
  room       integer,              -- once the guest is in the house
  status     varchar(10) not null  -- booked, in house, left, cancelled
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table menu (
  name  varchar(40) primary key,
  kind  varchar(16) not null,
  price integer     not null,      -- euros
  diet  varchar(12) not null       -- vegan, vegetarian, or empty
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table kitchen_order (
  id     integer primary key /*! auto_increment */,
  room   integer    not null,
  due    varchar(5) not null,      -- a time, or now
  status varchar(8) not null       -- ordered
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table order_item (
  order_id integer     not null,   -- kitchen_order.id
  item     varchar(40) not null,   -- menu.name
  amount   integer     not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table wake_up (
  id     integer primary key /*! auto_increment */,
  room   integer     not null,
  day    varchar(10) not null,
  time   varchar(5)  not null,
  status varchar(4)  not null      -- set, off, done
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table supply (
  id     integer primary key /*! auto_increment */,
  thing  varchar(20) not null,
  amount integer     not null,
  room   integer     not null,
  status varchar(8)  not null      -- ordered
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- What never closes is open from 00:00 to 24:00.
create table place (
  name        varchar(40)  primary key,
  floor       integer      not null,   -- ground floor 0, basement -1
  opens       varchar(5)   not null,
  closes      varchar(5)   not null,
  price       varchar(60)  not null,   -- to be spoken, or empty
  cents       integer      not null,   -- what one unit costs, or 0
  unit        varchar(8)   not null,   -- day, hour, page, bag, person, or empty
  description varchar(160) not null    -- a sentence to be spoken
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table fact (
  thing  varchar(40)  primary key,
  answer varchar(255) not null,
  cents  integer      not null,   -- as of a place
  unit   varchar(8)   not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- What is vegan suits vegetarians, too; what suits neither has meat or fish. What fills is told first, and what has
-- alcohol last.
create view menu_card as
  select name, kind, price, diet,
         case diet when 'vegan' then 'vegan, vegetarian' else diet end as suits,
         case when diet = '' then 'meat'
              when kind in ('hot drink', 'cold drink') then 'no alcohol' else '' end as features,
         case kind when 'main dish' then 1 when 'snack' then 2 when 'dessert' then 3
                   when 'breakfast' then 4 when 'hot drink' then 5 when 'cold drink' then 6
                   else 7 end as course
  from menu;
