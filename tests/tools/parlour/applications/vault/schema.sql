create table entry (pin integer not null unique);
