-- The database of the library: one schema for SQLite and MariaDB.
-- Dates are texts: 2026-11-28. `/*! … */` is for MariaDB only.

create table book (
  id      integer primary key,
  title   varchar(80) not null unique,
  author  varchar(80) not null,
  subject varchar(40) not null,   -- lower case: adventure, ghost stories
  form    varchar(16) not null,   -- book, audio book, film
  shelf   varchar(16) not null,   -- to be spoken: B4
  copies  integer     not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table member (
  card    integer primary key,    -- five digits
  name    varchar(80) not null,
  blocked integer     not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table loan (
  id       integer primary key /*! auto_increment */,
  book     integer     not null,  -- book.id
  card     integer     not null,  -- member.card
  due      varchar(10) not null,
  renewals integer     not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- A reservation that is given up is deleted. The queue is by id.
create table reservation (
  id     integer primary key /*! auto_increment */,
  book   integer     not null,
  card   integer     not null,
  placed varchar(10) not null,
  status varchar(8)  not null     -- waiting, or ready at the counter
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- 1 is Monday. A day without a row is a day on which it is closed.
create table opening (
  weekday integer primary key,
  opens   varchar(5) not null,
  closes  varchar(5) not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table place (
  name        varchar(40)  primary key,
  floor       varchar(40)  not null,
  description varchar(255) not null   -- a sentence to be spoken
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create table house_rule (
  thing  varchar(40)  primary key,
  answer varchar(255) not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- What one costs: a day, a page, a card; so that several can be told.
create table price (
  thing   varchar(40) not null,   -- house_rule.thing
  variant varchar(16) not null,   -- a word that is said of it, or nothing
  cents   integer     not null,
  primary key (thing, variant)
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- What readers are told: how many copies stand on the shelf, how many wait, when
-- the first copy comes back, and on which floor it is, where that is known.
create view catalogue as
  select id, title, author, subject, form, shelf,
         copies
           - (select count(*) from loan where loan.book = book.id)
           - (select count(*) from reservation
              where reservation.book = book.id
                and reservation.status = 'ready') as free,
         (select count(*) from reservation
          where reservation.book = book.id
            and reservation.status = 'waiting') as waiting,
         (select min(due) from loan where loan.book = book.id) as due,
         (select floor from place
          where (form <> 'book' and name = 'films')
             or (form = 'book' and subject = 'children'
                 and name = 'children''s library')) as floor
  from book;
