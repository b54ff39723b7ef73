create table robot (name text primary key, room text not null, skill text not null);
create table loan (robot text not null references robot (name), day text not null);
