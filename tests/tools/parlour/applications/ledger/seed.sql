insert into account (holder, balance, rate, opened) values
('Ann', 10, 2.5, '2026-11-01'), ('Ben', 20, null, '2026-11-02');
