create table booking (guest text not null, people text not null);
