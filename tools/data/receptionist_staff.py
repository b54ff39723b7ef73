"""The people who work in the building: some chosen by hand, most random."""

import receptionist_names

STAFF_COUNT = 640

# Departments and the floors they are on.
RESEARCH = {
    "Robotics": 8,
    "Speech and Language": 13,
    "Computer Vision": 14,
    "Data Analytics": 15,
    "Signal Processing": 16,
    "Networks and Security": 17,
    "Human Computer Interaction": 18,
}
OFFICES = {
    "Human Resource": 10,
    "Finance": 10,
    "Corporate Communications": 11,
    "Business Development": 12,
    "Information Technology": 19,
    "Legal and Procurement": 20,
    "Facilities Management": 7,
}

# Positions; one that is listed more often is drawn more often.
RESEARCH_POSTS = (
    ["Research Engineer"] * 5 + ["Scientist"] * 4
    + ["Senior Research Engineer"] * 3 + ["Senior Scientist"] * 2
    + ["Principal Scientist", "Research Intern", "Laboratory Manager"]
)
OFFICE_POSTS = (
    ["Executive"] * 4 + ["Senior Executive"] * 3 + ["Assistant Manager"] * 2
    + ["Manager"] * 2 + ["Senior Manager", "Secretary"]
)
DOCTORS = ("Scientist", "Senior Scientist", "Principal Scientist")

# (salutation, name, designation, department) of people that conversations rely
# on: the host of the paper's conversation; namesakes who differ only by title
# or department; names with similar spellings; and names that are hard to spell
# or to quote in SQL.
CHOSEN = [
    ("Dr.", "Jeffery Ho", "Principal Scientist", "Speech and Language"),
    ("Prof.", "Margaret Sim", "Executive Director", "Robotics"),
    ("Prof.", "Balasubramaniam s/o Thirunavukkarasu", "Director",
     "Signal Processing"),
    ("Dr.", "Tan Wei Ming", "Senior Scientist", "Robotics"),
    ("Mr.", "Tan Wei Ming", "Manager", "Finance"),
    ("Ms.", "Priya Nair", "Research Engineer", "Computer Vision"),
    ("Dr.", "Priya Nair", "Scientist", "Data Analytics"),
    ("Mr.", "Michael Lee", "Senior Executive", "Information Technology"),
    ("Mr.", "Michael Lee", "Executive", "Facilities Management"),
    ("Ms.", "Rachel Lim Hui Min", "Senior Executive", "Human Resource"),
    ("Ms.", "Rachel Lim", "Research Engineer", "Speech and Language"),
    ("Ms.", "Nurul Huda binte Ahmad", "Manager", "Corporate Communications"),
    ("Mr.", "Arun s/o Kumar", "Senior Research Engineer", "Robotics"),
    ("Mr.", "Allan Teo", "Executive", "Finance"),
    ("Dr.", "Alan Teo", "Scientist", "Networks and Security"),
    ("Ms.", "Catherine Neo", "Manager", "Human Resource"),
    ("Ms.", "Katherine Neo", "Executive", "Legal and Procurement"),
    ("Mr.", "Lee Zi Xuan", "Research Engineer", "Data Analytics"),
    ("Ms.", "Lee Zhi Xuan", "Research Engineer", "Data Analytics"),
    ("Mr.", "Mohamed Faizal bin Yusof", "Manager", "Facilities Management"),
    ("Mr.", "Muhammad Faisal bin Yusoff", "Research Engineer", "Robotics"),
    ("Dr.", "Siobhan O'Connor", "Senior Scientist",
     "Human Computer Interaction"),
    ("Mr.", "Jean-Pierre Rozario", "Manager", "Business Development"),
    ("Ms.", "Charmaine de Souza", "Secretary", "Robotics"),
    ("Dr.", "Quek Xue Qing", "Scientist", "Computer Vision"),
    ("Dr.", "Nguyen Thi Phuong Anh", "Scientist", "Signal Processing"),
    ("Mr.", "Ng Eng Hng", "Laboratory Manager", "Signal Processing"),
]


def level_of(department):
    return {**RESEARCH, **OFFICES}[department]


def salutation(gender, designation, draw):
    if designation in DOCTORS and draw.chance(0.8):
        return "Dr."
    if gender == "male":
        return "Mr."
    return "Mrs." if draw.chance(0.2) else "Ms."


def drawn_person(draw):
    gender = draw.one_of(["male", "female"])
    research = draw.chance(0.65)
    department = draw.one_of(list(RESEARCH if research else OFFICES))
    designation = draw.one_of(RESEARCH_POSTS if research else OFFICE_POSTS)
    title = salutation(gender, designation, draw)
    name = receptionist_names.name(gender, draw)
    return title, name, designation, department


def email(name, taken):
    """An address made from the name; namesakes get a number."""
    kept = [c if c.isalpha() else "." for c in name.lower().replace("'", "")]
    local = ".".join(part for part in "".join(kept).split(".") if part)
    taken[local] = taken.get(local, 0) + 1
    number = taken[local] if taken[local] > 1 else ""
    return f"{local}{number}@staff.example.com"


def people(draw):
    """All staff. The random ones have unique names; the chosen ones are put
    among them at random places."""
    drawn, names = [], {name for _, name, _, _ in CHOSEN}
    while len(drawn) < STAFF_COUNT - len(CHOSEN):
        person = drawn_person(draw)
        if person[1] not in names:
            names.add(person[1])
            drawn.append(person)
    for person in CHOSEN:
        drawn.insert(draw.below(len(drawn) + 1), person)
    return drawn


def rows(draw):
    """The rows of rr_staff."""
    result, taken = [], {}
    for index, person in enumerate(people(draw)):
        title, name, designation, department = person
        tower = draw.one_of(["North Tower", "South Tower"])
        result.append((
            1001 + index, title, name, designation,
            str(64781000 + 13 * index), email(name, taken), department,
            f"level {level_of(department)}, {tower}"))
    return result
