#!/usr/bin/env python3
"""Prints the receptionist's sample data as SQL.

The text is the same each time: all randomness comes from `Draw`, which has a
fixed seed. It loads into SQLite and MariaDB; the schema says which rules that
takes (config/apps/receptionist/sql/schema.sql).
"""

import random
import sys

import receptionist_facilities
import receptionist_meetings
import receptionist_staff

SEED = 20101121
ROWS_PER_INSERT = 100


class Draw:
    """A random generator that gives the same numbers in every version of
    Python. Of the standard generator, only `random()` promises that."""

    def __init__(self, seed):
        self._source = random.Random(seed)

    def below(self, bound):
        return int(self._source.random() * bound)

    def one_of(self, items):
        return items[self.below(len(items))]

    def chance(self, probability):
        return self._source.random() < probability


# The columns of each table, in the order of the rows below.
COLUMNS = {
    "rr_staff": "staff_id, salutation, staff_name, designation, telephone, "
                "email, department, location",
    "rr_facility": "facility_id, name, category, tags, unit, level, "
                   "description, contact",
    "rr_hours": "hours_id, facility, days, opens, closes",
    "rr_offer": "offer_id, offer",
    "rr_meeting": "meeting_id, date, time, venue, host, visitor, "
                  "organisation, status",
    "rr_visitor": "visitor_id, salutation, name, contact, email, "
                  "organisation",
}


def floor_code(level):
    return f"B{-level}" if level < 0 else f"{level:02d}"


def facility_rows():
    """Rows of rr_facility. Units are numbered along each floor."""
    rows, units = [], {}
    more = receptionist_facilities.OFFERS
    for index, facility in enumerate(receptionist_facilities.FACILITIES):
        name, category, tags, level, description = facility
        if name in more:
            tags += ", " + more[name]
        units[level] = units.get(level, 0) + 1
        unit = f"#{floor_code(level)}-{units[level]:02d}"
        rows.append((index + 1, name, category, tags, unit, level,
                     description, str(64072000 + 17 * index)))
    return rows


def offer_rows():
    """Rows of rr_offer: each tag that says what somebody looks for, once."""
    tags = [tag for row in facility_rows() for tag in row[3].split(", ")]
    offers = [tag for tag in dict.fromkeys(tags)
              if tag not in receptionist_facilities.NO_OFFERS]
    return [(index + 1, offer) for index, offer in enumerate(offers)]


def hours_rows():
    spans = [(name, *span)
             for name, hours in receptionist_facilities.HOURS.items()
             for span in hours]
    return [(index + 1, *span) for index, span in enumerate(spans)]


def literal(value):
    """A value in SQL. Only quotes are escaped, so no text may contain a
    backslash: MariaDB would read it as an escape."""
    if value is None:
        return "null"
    if isinstance(value, int):
        return str(value)
    return "'" + value.replace("'", "''") + "'"


def statement(table, rows):
    lines = ["(" + ", ".join(map(literal, row)) + ")" for row in rows]
    head = f"insert into {table}\n  ({COLUMNS[table]})\nvalues\n"
    return head + ",\n".join(lines) + ";\n"


def tables():
    """The rows of each table. The order of the calls matters: each one draws
    from the same generator."""
    draw = Draw(SEED)
    staff = receptionist_staff.rows(draw)
    meetings, visitors = receptionist_meetings.rows(staff, draw)
    return {"rr_staff": staff, "rr_facility": facility_rows(),
            "rr_hours": hours_rows(), "rr_offer": offer_rows(),
            "rr_meeting": meetings, "rr_visitor": visitors}


def seed():
    """The whole text of seed.sql."""
    parts = ["-- Made by tools/data/generate_receptionist.py: "
             "change that, not this.\n"]
    for table, rows in tables().items():
        for start in range(0, len(rows), ROWS_PER_INSERT):
            part = rows[start:start + ROWS_PER_INSERT]
            parts.append(statement(table, part))
    return "\n".join(parts)


if __name__ == "__main__":
    sys.stdout.reconfigure(newline="\n")
    sys.stdout.write(seed())
