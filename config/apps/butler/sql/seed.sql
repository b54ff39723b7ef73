insert into place (name) values
  ('hall'), ('kitchen'), ('living room'), ('bedroom'), ('study'), ('garage');
insert into thing (name, place, good_for) values
  ('red cup', 'kitchen', ''),
  ('blue cup', 'kitchen', ''),
  ('bottle of water', 'kitchen', 'drink'),
  ('apple', 'kitchen', 'eat'),
  ('newspaper', 'hall', 'read'),
  ('umbrella', 'hall', ''),
  ('reading glasses', 'bedroom', ''),
  ('remote control', 'living room', ''),
  ('laptop', 'study', ''),
  ('toolbox', 'garage', '');
