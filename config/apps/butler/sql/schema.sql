create table place (name text primary key);
create table thing (name text primary key, place text not null references place (name));
create table errand (
  thing text not null references thing (name),
  place text not null references place (name),
  status text not null check (status in ('brought', 'left', 'failed'))
);
