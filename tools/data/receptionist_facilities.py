"""The facilities of the building and their opening hours, written by hand.

FACILITIES has a row for each: name, category, tags, level, description. The
generator adds unit and telephone number. The swimming pool, the sky garden, the
auditorium, Star home, the food court and the two coffee shops come from the
paper's examples; the rest is invented. Do not add another coffee shop or food
court: the example conversation counts them.

OFFERS has more of what people look for in a place, in their words: it is added
to the tags. Of all tags those in NO_OFFERS are no words to look for a place by,
since they stand in other sentences, too.

HOURS has the opening hours, where they are known: days of the week (1 is
Monday), opening and closing time. They must agree with the description.
"""

OFFERS = {
    "Bicycle Bay": "bike",
    "Innovation Gallery": "look around, sightseeing",
    "Food Chain food court": "chicken rice, vegan food, breakfast, "
                             "dinner, a meal, something to eat, food",
    "Fresh Basket": "nappies, diapers, milk, water, vegetables, toiletries",
    "Daily Stop": "water, chewing gum, batteries, charger, "
                  "tissues, toothbrush, cigarettes",
    "Basement Cash Machine": "money",
    "Lobby Cash Machine": "money",
    "Starbucks Coffee": "tea, espresso, latte, cappuccino, muffin, "
                        "something to drink, drink",
    "Ya Kun Toastwich": "breakfast, toast, something to drink, drink",
    "Good Health Pharmacy": "tablets, pills, painkillers, aspirin, bandage, "
                            "something for a headache, cough medicine, "
                            "something for a cold, something for a cough, "
                            "first aid, paracetamol",
    "Paper Crane Books": "newspaper, pens, pencil, notebook, postcards, "
                         "birthday card, greeting card, stamps, envelope, "
                         "gifts",
    "Kelapa Kitchen": "malay food, a meal",
    "Saffron Table": "indian food, a meal",
    "White Pearl Dental": "toothache",
    "Silver Scissors": "hairdresser",
    "Evergreen Medical": "see a doctor, medical help, nurse, jab, vaccine, "
                         "injection, flu shot, checkup",
    "Nursing Room": "breastfeed, change a nappy, feed a baby, "
                    "baby changing",
    "Sharp Copies": "print something, make a copy, photocopy, scan",
    "Meridian Library": "read, study, somewhere quiet, a quiet place, "
                        "somewhere to sit, somewhere to work",
    "Sky garden": "somewhere to sit, a bench, fresh air, flowers, "
                  "somewhere to relax, sightseeing",
    "Prayer Room": "pray",
    "Swimming pool": "swimming, a swim",
    "Skyline Gym": "exercise, work out",
    "Cloud Terrace": "steak, cocktails, beer, pint, wine, a meal",
    "Merlin Cleaners": "tailor",
    "Bright Steps": "preschool",
    "Viewing Deck": "photos, pictures, sunset, sightseeing",
    "Star home": "sightseeing",
}

NO_OFFERS = {
    "drinks", "something to eat", "something to drink", "somewhere to sit",
    "somewhere to work", "somewhere to relax", "see a doctor", "make a copy",
    "print something", "change a nappy", "feed a baby", "work out",
    "look around", "a quiet place", "sightseeing",
    "first aid", "read", "study", "view",
    "help", "delivery", "collection", "parcel", "counter", "taxi", "cab",
    "pick up", "meeting", "course", "class", "workshop", "robot", "research",
    "demonstration", "quiet", "view", "outdoor", "stage", "conference", "tour",
    "exhibition", "science", "children", "mother", "baby", "screen", "video",
    "projector", "car", "goods", "lorry", "local", "dollars", "accessible",
    "train", "bus", "shuttle", "lane", "sport", "shower", "bar", "grill",
    "western", "malay", "indian", "savings", "loans", "mrt", "apartment",
    "smart home", "six seats", "eight seats", "twelve seats", "twenty seats",
    "circle line", "restroom", "washroom", "dentist", "doctor", "barber",
    "prayer", "atm", "cash", "parking", "lost property", "map", "nursery",
    "hall", "concert", "lecture", "swim",
}

FACILITIES = [
    # Basement two and one.
    ("Basement Car Park", "car park", "parking, car, season parking", -2,
     "The Basement Car Park is at basement two and is free of charge for "
     "the first ten minutes."),
    ("Bicycle Bay", "bicycle park", "bicycle, scooter, shower", -2,
     "The Bicycle Bay is at basement two, beside the lifts, with racks for "
     "eighty bicycles."),
    ("Loading Bay", "loading bay", "delivery, goods, lorry", -2,
     "The Loading Bay is at basement two and takes deliveries on weekdays "
     "from eight to six."),
    ("Food Chain food court", "food court",
     "rice, noodles, halal, vegetarian, lunch", -1,
     "Food Chain food court is at basement one and has fourteen stalls with "
     "local, halal and vegetarian food."),
    ("Fresh Basket", "supermarket", "groceries, fruit, drinks", -1,
     "Fresh Basket is a supermarket at basement one, open every day from "
     "eight in the morning to ten at night."),
    ("Daily Stop", "convenience store", "snacks, drinks, umbrella", -1,
     "Daily Stop is a convenience store at basement one that never closes."),
    ("MRT Entrance", "train station", "mrt, train, circle line", -1,
     "The MRT Entrance is at basement one, past the supermarket, and leads to "
     "the Circle Line."),
    ("Merlin Cleaners", "laundry", "dry cleaning, ironing, alterations", -1,
     "Merlin Cleaners at basement one returns a shirt on the same day."),
    ("Lion City Exchange", "money changer", "currency, ringgit, dollars", -1,
     "Lion City Exchange at basement one changes twenty currencies."),
    ("Basement Cash Machine", "cash machine", "atm, cash, withdrawal", -1,
     "The Basement Cash Machine is at basement one, facing the escalator."),
    ("Basement Toilets", "toilet", "washroom, restroom, accessible", -1,
     "The Basement Toilets are at basement one, behind the food court."),
    # First floor.
    ("Starbucks Coffee", "coffee shop", "coffee, cake, sandwich", 1,
     "Starbucks Coffee is on the first floor, at the main entrance, and "
     "opens at half past seven."),
    ("Ya Kun Toastwich", "coffee shop", "coffee, tea, kaya toast, eggs", 1,
     "Ya Kun Toastwich is on the first floor, across the atrium, and serves "
     "kaya toast with soft boiled eggs."),
    ("Straits Union Bank", "bank", "savings, loans, counter", 1,
     "Straits Union Bank is on the first floor and its counters are open on "
     "weekdays from nine to half past four."),
    ("Information Counter", "information counter", "help, map, lost property",
     1,
     "The Information Counter is on the first floor, in the middle of the "
     "atrium."),
    ("Taxi Stand", "taxi stand", "taxi, cab, pick up", 1,
     "The Taxi Stand is on the first floor, outside the main entrance."),
    ("Bus Stop", "bus stop", "bus, shuttle", 1,
     "The Bus Stop is on the first floor, at the east entrance, and the "
     "shuttle leaves every twenty minutes."),
    ("Good Health Pharmacy", "pharmacy", "medicine, plasters, vitamins", 1,
     "Good Health Pharmacy is on the first floor, next to the bank."),
    ("Lobby Cash Machine", "cash machine", "atm, cash, withdrawal", 1,
     "The Lobby Cash Machine is on the first floor, beside the lifts."),
    ("Paper Crane Books", "bookshop", "books, magazines, stationery", 1,
     "Paper Crane Books is on the first floor and has a shelf of local "
     "writers."),
    ("Parcel Wall", "parcel locker", "parcel, delivery, collection", 1,
     "The Parcel Wall is on the first floor, by the east entrance, and can "
     "be opened at any hour."),
    ("Lobby Toilets", "toilet", "washroom, restroom, accessible", 1,
     "The Lobby Toilets are on the first floor, to the left of the lifts."),
    # Second to fifth floor.
    ("Kelapa Kitchen", "restaurant", "malay, rendang, lunch, dinner", 2,
     "Kelapa Kitchen is a Malay restaurant on the second floor that is open "
     "for lunch and dinner."),
    ("Saffron Table", "restaurant", "indian, curry, vegetarian, dinner", 2,
     "Saffron Table is an Indian restaurant on the second floor with a "
     "vegetarian menu."),
    ("Harbour Commerce Bank", "bank", "business accounts, loans", 2,
     "Harbour Commerce Bank is on the second floor and serves business "
     "customers."),
    ("White Pearl Dental", "dental clinic", "dentist, teeth", 2,
     "White Pearl Dental is a dental clinic on the second floor that sees "
     "patients by appointment."),
    ("Silver Scissors", "hair salon", "haircut, barber", 2,
     "Silver Scissors is a hair salon on the second floor that takes "
     "customers without a booking."),
    ("Second Floor Toilets", "toilet", "washroom, restroom", 2,
     "The Second Floor Toilets are on the second floor, behind the hair "
     "salon."),
    ("Evergreen Medical", "clinic", "doctor, vaccination, health check", 3,
     "Evergreen Medical is a clinic on the third floor with two doctors, "
     "open on weekdays and on Saturday morning."),
    ("Bright Steps", "childcare centre", "children, nursery", 3,
     "Bright Steps is a childcare centre on the third floor for children "
     "from eighteen months to six years."),
    ("Nursing Room", "nursing room", "baby, mother, quiet", 3,
     "The Nursing Room is on the third floor, beside the childcare centre."),
    ("Sharp Copies", "print shop", "printing, copying, binding", 3,
     "Sharp Copies is a print shop on the third floor that binds documents "
     "while you wait."),
    ("Innovation Gallery", "gallery", "exhibition, science, tour", 4,
     "The Innovation Gallery is on the fourth floor and shows what is made "
     "in this building."),
    ("Auditorium", "hall", "lecture, concert, conference, stage", 5,
     "The Auditorium is on the fifth floor and has three hundred and twenty "
     "seats."),
    ("Fifth Floor Toilets", "toilet", "washroom, restroom, accessible", 5,
     "The Fifth Floor Toilets are on the fifth floor, at the doors of the "
     "Auditorium."),
    # Offices and meeting rooms.
    ("Meridian Library", "library", "books, journals, reading", 6,
     "The Meridian Library is on the sixth floor, and visitors may read "
     "there without a card."),
    ("Training Centre", "training room", "course, class, workshop", 7,
     "The Training Centre is on the seventh floor and has four class rooms."),
    ("Robotics Laboratory", "laboratory", "robot, research, demonstration", 8,
     "The Robotics Laboratory is on the eighth floor and may be visited with "
     "a host."),
    ("Prayer Room", "prayer room", "prayer, quiet", 9,
     "The Prayer Room is on the ninth floor and is open to everyone."),
    ("Orchid Room", "meeting room", "meeting, projector, twelve seats", 11,
     "The Orchid Room is a meeting room for twelve on the eleventh floor, with "
     "a projector."),
    ("Jasmine Room", "meeting room", "meeting, screen, six seats", 11,
     "The Jasmine Room is a meeting room for six on the eleventh floor, with a "
     "screen."),
    ("Star home", "showroom", "smart home, demonstration, apartment", 12,
     "Star home is an apartment of the future on the twelfth floor, shown "
     "every hour."),
    ("Angsana Room", "meeting room", "meeting, projector, twenty seats", 13,
     "The Angsana Room is a meeting room for twenty on the thirteenth floor, "
     "with a projector."),
    ("Tembusu Room", "meeting room", "meeting, video, eight seats", 17,
     "The Tembusu Room is a meeting room for eight on the seventeenth floor, "
     "with a video link."),
    # Roof.
    ("Sky garden", "garden", "plants, view, benches, outdoor", 21,
     "The Sky garden is on the twenty first floor and is open until sunset."),
    ("Swimming pool", "pool", "swim, sport, lane", 23,
     "The Swimming pool is on the twenty third floor, in the open air, and "
     "is open from seven in the morning to nine at night."),
    ("Skyline Gym", "gym", "fitness, sport, yoga, weights", 23,
     "The Skyline Gym is on the twenty third floor, beside the swimming "
     "pool."),
    ("Poolside Toilets", "toilet", "washroom, restroom, showers, lockers", 23,
     "The Poolside Toilets are on the twenty third floor and have showers "
     "and lockers."),
    ("Cloud Terrace", "restaurant", "western, grill, bar, dinner", 24,
     "Cloud Terrace is a restaurant on the twenty fourth floor that opens "
     "for dinner at six."),
    ("Viewing Deck", "viewing deck", "view, photographs, outdoor", 24,
     "The Viewing Deck is on the twenty fourth floor, around the "
     "restaurant."),
]

EVERY_DAY = "1234567"
WEEKDAYS = "12345"


def daily(opens, closes):
    return [(EVERY_DAY, opens, closes)]


def weekdays(opens, closes):
    return [(WEEKDAYS, opens, closes)]


NEVER_CLOSES = daily("00:00", "24:00")

HOURS = {
    "Basement Car Park": NEVER_CLOSES,
    "Loading Bay": weekdays("08:00", "18:00"),
    "Food Chain food court": daily("07:00", "21:30"),
    "Fresh Basket": daily("08:00", "22:00"),
    "Daily Stop": NEVER_CLOSES,
    "Merlin Cleaners": weekdays("08:00", "19:00") + [("6", "09:00", "17:00")],
    "Lion City Exchange": daily("09:00", "20:00"),
    "Starbucks Coffee": daily("07:30", "21:00"),
    "Ya Kun Toastwich": weekdays("07:00", "19:00") + [("6", "08:00", "15:00")],
    "Straits Union Bank": weekdays("09:00", "16:30"),
    "Information Counter": daily("08:00", "22:00"),
    "Good Health Pharmacy": daily("09:00", "21:00"),
    "Paper Crane Books": daily("10:00", "20:00"),
    "Parcel Wall": NEVER_CLOSES,
    "Kelapa Kitchen": daily("11:30", "14:30") + daily("18:00", "22:00"),
    "Saffron Table": daily("11:30", "14:30") + daily("18:00", "22:00"),
    "Harbour Commerce Bank": weekdays("09:30", "16:00"),
    "White Pearl Dental": weekdays("09:00", "18:00"),
    "Silver Scissors": [("23456", "10:00", "20:00"), ("7", "10:00", "17:00")],
    "Evergreen Medical": weekdays("08:30", "17:30") + [
        ("6", "08:30", "12:30")],
    "Bright Steps": weekdays("07:00", "19:00"),
    "Sharp Copies": weekdays("09:00", "18:00"),
    "Innovation Gallery": [("234567", "10:00", "18:00")],
    "Meridian Library": weekdays("08:00", "20:00") + [("6", "09:00", "17:00")],
    "Star home": weekdays("10:00", "17:00"),
    "Sky garden": daily("07:00", "19:00"),
    "Swimming pool": daily("07:00", "21:00"),
    "Skyline Gym": daily("06:00", "22:00"),
    "Cloud Terrace": daily("18:00", "23:00"),
    "Viewing Deck": daily("09:00", "22:00"),
}
