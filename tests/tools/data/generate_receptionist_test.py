#!/usr/bin/env python3
"""Tests the receptionist's sample data: generates it, loads it into SQLite and
checks what conversations rely on."""

import pathlib
import re
import sqlite3
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
GENERATOR = ROOT / "tools/data/generate_receptionist.py"
SQL = ROOT / "config/apps/receptionist/sql"


def committed(name):
    return (SQL / name).read_bytes()


def generated():
    command = [sys.executable, "-B", str(GENERATOR)]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout


class Database(unittest.TestCase):
    """A fresh database for each test, and short ways to ask it."""

    def setUp(self):
        self.connection = sqlite3.connect(":memory:")
        self.addCleanup(self.connection.close)
        for name in ("schema.sql", "seed.sql"):
            self.connection.executescript(committed(name).decode("ascii"))

    def rows(self, query, *values):
        return self.connection.execute(query, values).fetchall()

    def column(self, query, *values):
        return [row[0] for row in self.rows(query, *values)]

    def one(self, query, *values):
        (row,) = self.rows(query, *values)
        return row[0]

    def names_in(self, category, level=None):
        return self.column(
            "select name from rr_facility where category = ?1 and "
            "(?2 is null or level = ?2) order by name", category, level)


class Text(unittest.TestCase):
    def test_generator_gives_the_committed_seed(self):
        self.assertEqual(generated(), committed("seed.sql"))

    def test_generator_repeats_itself(self):
        self.assertEqual(generated(), generated())

    def test_seed_avoids_what_the_databases_read_differently(self):
        text = committed("seed.sql").decode("ascii")
        self.assertNotIn("\\", text)
        self.assertNotIn("\r", text)
        for literal in re.findall(r"'(?:[^']|'')*'", text):
            self.assertNotIn(";", literal)

    def test_a_simple_splitter_finds_the_ends_of_statements(self):
        for comment in re.findall("--.*", committed("schema.sql").decode()):
            self.assertNotRegex(comment, "[;'\"]")

    def test_schema_hides_what_only_one_database_knows(self):
        plain = committed("schema.sql").decode("ascii")
        plain = re.sub(r"--.*|/\*!.*?\*/", "", plain).lower()
        for word in ("auto", "collate", "engine", "pragma", "`", '"'):
            self.assertNotIn(word, plain)


class Staff(Database):
    def test_more_than_six_hundred(self):
        self.assertGreater(self.one("select count(*) from rr_staff"), 600)

    def test_ids_telephones_and_emails_are_unique(self):
        for column in ("staff_id", "telephone", "email"):
            values = self.column(f"select {column} from rr_staff")
            self.assertEqual(len(values), len(set(values)), column)

    def test_every_field_is_filled(self):
        for row in self.rows("select * from rr_staff"):
            self.assertTrue(all(row), row)

    def test_normal_forms(self):
        query = "select salutation, staff_name, telephone, email from rr_staff"
        for salutation, name, telephone, email in self.rows(query):
            self.assertIn(salutation, ("Dr.", "Mr.", "Mrs.", "Ms.", "Prof."))
            self.assertRegex(name, r"^[A-Z][A-Za-z'/-]*( [A-Za-z'/-]+)+$")
            self.assertRegex(telephone, r"^6\d{7}$")
            self.assertRegex(email, r"^[a-z.]+\d?@staff\.example\.com$")

    def test_the_papers_host_is_there_once(self):
        titles = self.column("select salutation from rr_staff "
                             "where staff_name = 'Jeffery Ho'")
        self.assertEqual(titles, ["Dr."])

    def test_surnames_are_shared(self):
        hos = self.column("select staff_name from rr_staff where "
                          "' ' || staff_name || ' ' like '% Ho %'")
        self.assertGreater(len(hos), 3)
        jeffs = [name for name in hos if name.startswith("Jeff")]
        self.assertEqual(jeffs, ["Jeffery Ho"])

    def test_only_the_chosen_namesakes(self):
        shared = self.column("select staff_name from rr_staff group by 1 "
                             "having count(*) > 1 order by 1")
        self.assertEqual(shared, ["Michael Lee", "Priya Nair", "Tan Wei Ming"])

    def test_names_in_all_orders(self):
        for part in ("Tan %", "% Tan", "% Tan %", "% bin %", "% s/o %",
                     "% d/o %", "% Nair", "% de Souza", "%O'Connor"):
            found = self.column("select staff_name from rr_staff "
                                "where staff_name like ?", part)
            self.assertTrue(found, part)


class Facilities(Database):
    def test_fifty(self):
        self.assertEqual(self.one("select count(*) from rr_facility"), 50)

    def test_names_and_units_are_unique(self):
        for column in ("lower(name)", "unit"):
            values = self.column(f"select {column} from rr_facility")
            self.assertEqual(len(values), len(set(values)), column)

    def test_columns(self):
        columns = self.connection.execute("select * from rr_facility")
        self.assertEqual(
            [column[0] for column in columns.description],
            ["facility_id", "name", "category", "tags", "unit", "level",
             "description", "contact"])

    def test_normal_forms(self):
        query = ("select name, category, unit, level, description, contact "
                 "from rr_facility")
        for name, category, unit, level, description, contact in self.rows(
                query):
            self.assertIn(name, description)
            self.assertRegex(category, r"^[a-z]+( [a-z]+)*$")
            self.assertRegex(description, r"^[A-Z][^.!?]*\.$")
            self.assertRegex(contact, r"^6\d{7}$")
            self.assertIsInstance(level, int)
            floor = f"B{-level}" if level < 0 else f"{level:02d}"
            self.assertTrue(unit.startswith(f"#{floor}-"), unit)
            self.assertNotEqual(level, 0)

    def test_coffee_shops_are_on_the_first_floor_only(self):
        both = ["Starbucks Coffee", "Ya Kun Toastwich"]
        self.assertEqual(self.names_in("coffee shop", 1), both)
        self.assertEqual(self.names_in("coffee shop"), both)

    def test_one_food_court_at_basement_one(self):
        one = ["Food Chain food court"]
        self.assertEqual(self.names_in("food court", -1), one)
        self.assertEqual(self.names_in("food court"), one)

    def test_the_papers_other_places(self):
        for name in ("Swimming pool", "Sky garden", "Auditorium",
                     "Star home"):
            self.one("select level from rr_facility where name = ?", name)
        self.assertRegex(
            self.one("select description from rr_facility "
                     "where name = 'Swimming pool' and level = 23"),
            "^The Swimming pool is on the twenty third floor,")

    def test_something_to_relax_and_to_follow_up(self):
        self.assertEqual(self.names_in("bank", 1), ["Straits Union Bank"])
        self.assertEqual(self.names_in("bank", 2), ["Harbour Commerce Bank"])
        self.assertEqual(len(self.names_in("restaurant", 2)), 2)
        self.assertEqual(self.names_in("clinic", 1), [])


class Hours(Database):
    def test_normal_forms(self):
        query = "select days, opens, closes from rr_hours"
        for days, opens, closes in self.rows(query):
            self.assertRegex(days, r"^1?2?3?4?5?6?7?$")
            self.assertTrue(days)
            for time in (opens, closes):
                self.assertRegex(time, r"^([01]\d|2[0-4]):[0-5]\d$")
            self.assertLess(opens, closes)
            self.assertLessEqual(closes, "24:00")

    def test_facilities_exist(self):
        lost = self.rows("select * from rr_hours where facility not in "
                         "(select name from rr_facility)")
        self.assertEqual(lost, [])

    def test_no_two_of_a_day_overlap(self):
        rows = self.rows("select facility, days, opens, closes from rr_hours "
                         "order by facility, opens")
        for day in "1234567":
            spans = [row for row in rows if day in row[1]]
            for before, after in zip(spans, spans[1:]):
                if before[0] == after[0]:
                    self.assertLess(before[3], after[2], before[0])

    def test_all_kinds_are_there(self):
        self.assertTrue(self.rows("select * from rr_hours where opens = "
                                  "'00:00' and closes = '24:00'"))
        self.assertTrue(self.rows("select facility from rr_hours where days = "
                                  "'1234567' group by 1 having count(*) > 1"))
        self.assertTrue(self.rows("select name from rr_facility where name "
                                  "not in (select facility from rr_hours)"))


class Meetings(Database):
    def test_normal_forms(self):
        for date, time in self.rows("select date, time from rr_meeting"):
            self.assertRegex(date, r"^2026-(11|12)-\d\d$")
            self.assertGreaterEqual(date, "2026-11-21")
            self.assertRegex(time, r"^\d\d:\d\d$")

    def test_hosts_and_venues_exist(self):
        lost = self.rows(
            "select * from rr_meeting where "
            "host not in (select staff_name from rr_staff) or venue not in "
            "(select name from rr_facility where category = 'meeting room')")
        self.assertEqual(lost, [])

    def test_nobody_and_no_room_is_taken_twice(self):
        for column in ("host", "venue"):
            self.assertEqual(
                self.rows(f"select {column} from rr_meeting "
                          f"group by {column}, date, time "
                          "having count(*) > 1"), [])

    def test_the_papers_host_is_free_at_half_past_ten(self):
        times = self.column("select time from rr_meeting where "
                            "host = 'Jeffery Ho' and date = '2026-11-21'")
        self.assertEqual(times, ["14:00"])

    def test_somebody_is_busy_and_somebody_no_longer(self):
        query = ("select status from rr_meeting where host = ? "
                 "and date = '2026-11-21' and time = '10:30'")
        self.assertEqual(self.one(query, "Margaret Sim"), "booked")
        self.assertEqual(self.one(query, "Rachel Lim Hui Min"), "cancelled")

    def test_the_papers_visitor_is_not_expected(self):
        for table in ("rr_meeting", "rr_visitor"):
            self.assertEqual(self.rows(f"select * from {table} where "
                                       "organisation = 'Comptec'"), [])

    def test_meetings_and_visitors_agree(self):
        self.assertEqual(
            self.rows("select visitor, organisation from rr_meeting "
                      "where (visitor, organisation) not in "
                      "(select name, organisation from rr_visitor)"), [])


class Inserts(Database):
    """What the dialogue writes needs no id."""

    def test_next_ids_are_given(self):
        for table, key, columns, values in (
                ("rr_meeting", "meeting_id", "date, time, host",
                 ("2026-11-21", "10:30", "Jeffery Ho")),
                ("rr_visitor", "visitor_id", "name, organisation",
                 ("David", "Comptec")),
                ("rr_taxi", "booking_id", "telephone, date, time",
                 ("91234567", "2026-11-21", "18:00"))):
            last = self.one(f"select coalesce(max({key}), 0) from {table}")
            marks = ", ".join("?" * len(values))
            self.connection.execute(
                f"insert into {table} ({columns}) values ({marks})", values)
            self.assertEqual(self.one(f"select max({key}) from {table}"),
                             last + 1)


if __name__ == "__main__":
    unittest.main()
