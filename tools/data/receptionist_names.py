"""Random Singapore names in their usual word orders, from lists of common
parts.

Chinese: surname first ("Tan Wei Ming"), with an English name before the
surname ("Jeffery Ho"), or with both ("Rachel Lim Hui Min"). Malay: a given
name and the father's ("Nurul Huda binte Ahmad"). Indian: the father's name
after s/o or d/o ("Arun s/o Kumar"), or a family name ("Priya Nair").
English and Eurasian: given and family name.
"""

CHINESE_SURNAMES = """
    Tan Tan Tan Lim Lim Lim Lee Lee Ng Ng Ong Wong Goh Chua Chan Koh Teo Ang
    Yeo Tay Ho Ho Low Toh Sim Chong Chia Seah Quek Foo Phua Loh Neo Heng Kwok
    Chew Leong Yap Tham Soh Zhang Wang Liu Chen Xu Zhao Huang
""".split()

CHINESE_GIVEN = {
    "male": [
        "Wei Jie", "Jun Hao", "Kok Leong", "Boon Keng", "Chee Meng",
        "Zhi Hao", "Kai Xiang", "Yong Sheng", "Teck Huat", "Wen Jie",
        "Ming Hui", "Guan Hock", "Jia Jun", "Swee Kiat", "Hock Seng",
        "Yi Xuan", "Zhen Yu", "Kah Wai", "Choon Kiat", "De Ming",
    ],
    "female": [
        "Hui Min", "Jia Hui", "Xin Yi", "Mei Ling", "Siew Hoon", "Li Ting",
        "Shu Fen", "Wan Ting", "Yi Ling", "Pei Shan", "Bee Lian", "Xiu Wen",
        "Jing Yi", "Sok Hwee", "Hwee Leng", "Qian Hui", "Ai Ling",
        "Zi Xuan", "Min Yi", "Lay Peng",
    ],
}

ENGLISH_GIVEN = {
    "male": """
        Adrian Alan Andrew Benjamin Bernard Brandon Bryan Calvin Christopher
        Clarence Daniel Darren David Dennis Desmond Dominic Edmund Edwin Eric
        Eugene Gabriel Gerald Gordon Henry Ivan Jason Jonathan Joseph Kelvin
        Kenneth Lawrence Leonard Marcus Matthew Melvin Nicholas Patrick Peter
        Raymond Richard Roland Samuel Shaun Simon Stanley Steven Terence
        Timothy Victor Vincent Wilfred William
    """.split(),
    "female": """
        Abigail Adeline Alicia Amanda Angela Audrey Belinda Bernice Brenda
        Catherine Charlotte Cheryl Christine Clara Cynthia Deborah Diana
        Doreen Elaine Esther Eunice Evelyn Felicia Fiona Geraldine Gillian
        Grace Hazel Irene Jacqueline Janice Joanna Josephine Karen
        Lorraine Magdalene Margaret Michelle Natalie Nicole Pamela Patricia
        Priscilla Rebecca Sabrina Serene Shirley Stephanie Sylvia Theresa
        Valerie Vanessa Vivian Yvonne
    """.split(),
}

ENGLISH_SURNAMES = """
    Anderson Bennett Campbell Clarke Collins Davies Edwards Fraser Graham
    Harrison Hughes Jenkins Mitchell Morgan Murray Palmer Parker Phillips
    Roberts Shaw Stewart Thompson Turner Walker Watson Wright Pereira Rozario
    Oliveiro Monteiro Sequeira Westerhout Aeria
""".split()

MALAY_GIVEN = {
    "male": [
        "Ahmad", "Faizal", "Hafiz", "Iskandar", "Muhammad Firdaus",
        "Muhammad Hakim", "Muhammad Danish", "Mohamed Rashid", "Azman",
        "Khairul", "Zulkarnain", "Ridzuan", "Shahrul", "Fadhil", "Amirul",
        "Syed Imran", "Norman", "Hairul Nizam",
    ],
    "female": [
        "Nur Aisyah", "Siti Khadijah", "Siti Aminah", "Nurul Ain", "Farhana",
        "Haslinda", "Nadiah", "Rosnah", "Zarina", "Nur Syafiqah", "Hidayah",
        "Suriani", "Noraini", "Faridah", "Izzati", "Sharifah Nora",
    ],
}

MALAY_FATHERS = """
    Ismail Hassan Osman Rahman Yusof Salleh Jamal Kassim Mahmud Othman
    Abdullah Hamid Sulaiman Ibrahim Latiff Zainal Bakar Samad
""".split()

INDIAN_GIVEN = {
    "male": """
        Anand Arjun Balakrishnan Deepak Ganesan Gopal Harish Jeevan Karthik
        Manoj Mohan Prakash Rajesh Ramesh Ravi Sanjay Saravanan Senthil
        Shankar Suresh Vijay Vignesh
    """.split(),
    "female": """
        Anitha Bhavani Deepa Devi Geetha Indira Kavitha Lakshmi Malathi Meena
        Nirmala Padma Revathi Rukmani Shanthi Sangeetha Subashini Sumathi
        Thilagavathi Uma Vasantha Vijayalakshmi
    """.split(),
}

INDIAN_FATHERS = """
    Arumugam Chandran Govindasamy Krishnan Letchumanan Manickam Muthusamy
    Nadarajan Palaniappan Perumal Rajendran Ramasamy Selvam Subramaniam
    Sivalingam Thangavelu Veerasamy
""".split()

INDIAN_SURNAMES = """
    Nair Menon Pillai Iyer Rao Singh Kaur Sharma Gupta Reddy Chatterjee Bose
    Krishnamurthy Venkataraman
""".split()


def chinese(gender, draw):
    surname = draw.one_of(CHINESE_SURNAMES)
    given = draw.one_of(CHINESE_GIVEN[gender])
    english = draw.one_of(ENGLISH_GIVEN[gender])
    return draw.one_of([
        f"{surname} {given}",
        f"{surname} {given}",
        f"{english} {surname}",
        f"{english} {surname} {given}",
    ])


def malay(gender, draw):
    link = "bin" if gender == "male" else draw.one_of(["binte", "binti"])
    given = draw.one_of(MALAY_GIVEN[gender])
    return f"{given} {link} {draw.one_of(MALAY_FATHERS)}"


def indian(gender, draw):
    given = draw.one_of(INDIAN_GIVEN[gender])
    link = "s/o" if gender == "male" else "d/o"
    surname = draw.one_of(INDIAN_SURNAMES)
    if surname in ("Singh", "Kaur"):  # the same name in two forms
        surname = "Singh" if gender == "male" else "Kaur"
    return draw.one_of([
        f"{given} {link} {draw.one_of(INDIAN_FATHERS)}",
        f"{given} {surname}",
    ])


def english(gender, draw):
    given = draw.one_of(ENGLISH_GIVEN[gender])
    return f"{given} {draw.one_of(ENGLISH_SURNAMES)}"


# Roughly the shares of the city's communities.
COMMUNITIES = [chinese] * 13 + [malay] * 3 + [indian] * 3 + [english] * 1


def name(gender, draw):
    return draw.one_of(COMMUNITIES)(gender, draw)
