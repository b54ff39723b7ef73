create table place (name text primary key);
-- What a thing is good for: drink, eat or read; empty for others.
create table thing (
  name text primary key,
  place text not null references place (name),
  good_for text not null
);
create table errand (
  thing text not null references thing (name),
  place text not null references place (name),
  status text not null check (status in ('brought', 'left', 'failed'))
);
