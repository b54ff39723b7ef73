insert into place (name) values
  ('hall'), ('kitchen'), ('living room'), ('bedroom'), ('study'), ('garage');
insert into thing (name, place) values
  ('red cup', 'kitchen'),
  ('blue cup', 'kitchen'),
  ('bottle of water', 'kitchen'),
  ('apple', 'kitchen'),
  ('newspaper', 'hall'),
  ('umbrella', 'hall'),
  ('reading glasses', 'bedroom'),
  ('remote control', 'living room'),
  ('laptop', 'study'),
  ('toolbox', 'garage');
