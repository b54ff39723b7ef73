insert into room (name) values
  ('living room'), ('kitchen'), ('bedroom'), ('bathroom'), ('hall');
