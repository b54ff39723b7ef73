create table room (name text primary key);
create table reminder (
  id integer primary key,
  what text not null,
  due text not null,
  status text not null check (status in ('waits', 'told', 'dropped'))
);
