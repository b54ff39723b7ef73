"""Two weeks of booked meetings, and the visitors who are expected.

Meetings at the same time get different rooms. Jeffery Ho has no meeting on the
first morning, because the paper's conversation needs him at half past ten.
"""

import datetime

import receptionist_names

FIRST_DAY = datetime.date(2026, 11, 21)
DAYS = 14
TIMES = ["09:00", "10:30", "11:00", "14:00", "15:30", "16:30"]
VENUES = ["Orchid Room", "Jasmine Room", "Angsana Room", "Tembusu Room"]
ORGANISATIONS = [
    "Merbau Systems", "Lotus Analytics", "Kestrel Robotics",
    "Straits Polytechnic", "Pasir Instruments", "Blue Orchid Media",
    "Tanglin Medical", "Nusantara Logistics", "Quayside Capital",
    "Rambutan Games",
]

# (host, date, time, status): meetings that conversations rely on.
CHOSEN = [
    ("Jeffery Ho", "2026-11-21", "14:00", "booked"),
    ("Margaret Sim", "2026-11-21", "10:30", "booked"),
    ("Rachel Lim Hui Min", "2026-11-21", "10:30", "cancelled"),
    ("Nurul Huda binte Ahmad", "2026-11-21", "11:00", "booked"),
    ("Arun s/o Kumar", "2026-11-21", "15:30", "booked"),
    ("Jeffery Ho", "2026-11-24", "10:30", "booked"),
]


def visitor(draw):
    """A row of rr_visitor without its id. Half of the visitors have a
    telephone number, and half of these an e-mail address."""
    gender = draw.one_of(["male", "female"])
    name = receptionist_names.name(gender, draw)
    organisation = draw.one_of(ORGANISATIONS)
    contact = str(60200000 + draw.below(99999)) if draw.chance(0.5) else None
    email = None
    if contact and draw.chance(0.5):
        letters = "".join(c for c in name.split()[0].lower() if c.isalpha())
        firm = organisation.lower().replace(" ", "-")
        email = f"{letters}@{firm}.example.com"
    title = "Mr." if gender == "male" else "Ms."
    return title, name, contact, email, organisation


def drawn_engagements(hosts, draw):
    """Random meetings, at most one for each time of each day."""
    for day in range(DAYS):
        date = (FIRST_DAY + datetime.timedelta(days=day)).isoformat()
        for time in TIMES:
            if draw.chance(0.7):
                status = "cancelled" if draw.chance(0.1) else "booked"
                yield draw.one_of(hosts), date, time, status


def engagements(staff, draw):
    """The chosen and the random meetings, by date and time. Hosts who have a
    namesake or a chosen meeting get no random ones, so that tests can rely on
    their calendars."""
    names = [row[2] for row in staff]
    kept = {host for host, _, _, _ in CHOSEN}
    hosts = [n for n in names if names.count(n) == 1 and n not in kept]
    everyone = CHOSEN + list(drawn_engagements(hosts, draw))
    return sorted(everyone, key=lambda e: (e[1], e[2], e[0]))


def rows(staff, draw):
    """The rows of rr_meeting and of rr_visitor."""
    meetings, visitors, used = [], [], {}
    for host, date, time, status in engagements(staff, draw):
        guest = visitor(draw)
        room = used[date, time] = used.get((date, time), -1) + 1
        meetings.append((len(meetings) + 1, date, time, VENUES[room], host,
                         guest[1], guest[4], status))
        visitors.append((len(visitors) + 1, *guest))
    return meetings, visitors
