-- The database of the receptionist: one schema for SQLite and MariaDB.
--
-- What makes it load into both unchanged:
--
-- * Ids that the dialogue leaves out of its inserts are written
--   `integer primary key /*! auto_increment */`. SQLite numbers an `integer
--   primary key` by itself and takes the rest for a comment, MariaDB runs
--   what stands between the marks. So whoever loads this file must pass
--   comments on, not strip them.
-- * The same way MariaDB is told to store UTF-8 and to compare byte by byte,
--   as SQLite does: `=` and `order by` mean the same in both. Not so `like`:
--   in SQLite it ignores the case of a to z, in MariaDB it then does not.
-- * No text in the seed has a backslash (an escape in MariaDB only) or a
--   semicolon, and these comments have no quotation mark and no semicolon,
--   so that even a simple splitter of statements finds their ends.
--
-- Normal forms: date 2026-11-21, time 10:30, telephone digits only.
-- A value that nobody has told is null. SQLite does not enforce lengths,
-- MariaDB does. There is no transaction in either file: the loader opens it.

create table rr_staff (
  staff_id    integer primary key,
  salutation  varchar(8)  not null,   -- Dr. Mr. Mrs. Ms. Prof.
  staff_name  varchar(80) not null,   -- full, without salutation, not unique
  designation varchar(80) not null,
  telephone   varchar(16) not null,
  email       varchar(80) not null,
  department  varchar(80) not null,
  location    varchar(80) not null    -- to be spoken: level 13, North Tower
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create index rr_staff_by_name on rr_staff (staff_name);

-- The order of these columns is part of the contract: the description is
-- column 6, counted from 0, of `select *`.
create table rr_facility (
  facility_id integer primary key,
  name        varchar(80)  not null unique,
  category    varchar(40)  not null,  -- lower case, singular: coffee shop
  tags        varchar(400) not null,  -- products and services: tea, toast
  unit        varchar(16)  not null,  -- #01-05, #B1-02
  level       integer      not null,  -- first floor 1, basement one -1, no 0
  description varchar(255) not null,  -- one sentence to be spoken
  contact     varchar(16)  not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create index rr_facility_by_category on rr_facility (category, level);

-- What visitors look for by other words than a name or a category: the tags of
-- rr_facility that stand in no other sentences, once each.
create table rr_offer (
  offer_id integer primary key,
  offer    varchar(40) not null unique
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

-- When a facility is open: on these days of the week, from a time until another
-- of the same day. It has several rows where it closes in between or where days
-- differ, and none where nobody knows. What never closes is open every day from
-- 00:00 to 24:00.
create table rr_hours (
  hours_id integer primary key,
  facility varchar(80) not null,  -- rr_facility.name
  days     varchar(7)  not null,  -- 12345 is Monday to Friday
  opens    varchar(5)  not null,
  closes   varchar(5)  not null
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create index rr_hours_by_facility on rr_hours (facility, opens);

-- The host is the name of a staff member, as in rr_staff.staff_name. A host may
-- have two rows for one time: it is the dialogue that says who is busy.
create table rr_meeting (
  meeting_id   integer primary key /*! auto_increment */,
  date         varchar(10) not null,
  time         varchar(5)  not null,
  venue        varchar(80),
  host         varchar(80) not null,
  visitor      varchar(80),
  organisation varchar(80),
  status       varchar(16) not null default 'booked'  -- or cancelled, arrived
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create index rr_meeting_by_host on rr_meeting (host, date, time);
create index rr_meeting_by_day on rr_meeting (status, date, time);

-- Whom the grammars know. No conversation changes it: what is understood would
-- have to be learnt anew.
create view rr_expected as
  select visitor, organisation from rr_meeting where status in ('booked', 'cancelled');

create table rr_visitor (
  visitor_id   integer primary key /*! auto_increment */,
  salutation   varchar(8),
  name         varchar(80) not null,
  contact      varchar(16),
  email        varchar(80),
  organisation varchar(80)
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;

create index rr_visitor_by_name on rr_visitor (name);

-- What the receptionist booked for its visitors, nothing at first. The plate
-- comes from the taxi company, so it is null until that answers.
create table rr_taxi (
  booking_id  integer primary key /*! auto_increment */,
  visitor     varchar(80),
  telephone   varchar(16) not null,   -- where the plate number is sent
  destination varchar(120),
  date        varchar(10) not null,
  time        varchar(5)  not null,
  plate       varchar(16),
  status      varchar(16) not null default 'requested'  -- booked, failed
) /*! character set utf8mb4 collate utf8mb4_nopad_bin */;
