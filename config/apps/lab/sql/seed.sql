insert into robot (name, room, skill) values
  ('Rover', 'room 12', 'grasping'),
  ('Pepper', 'room 3', 'talking'),
  ('Spot', 'room 12', 'walking');
