create tabel guest (name text);
