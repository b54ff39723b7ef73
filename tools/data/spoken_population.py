"""A second population of Singapore names, for the last part of the trial of
spoken names: other family and given names than `receptionist_names`, so that
nothing can be tuned to them by looking at the sample data.
"""

CHINESE_SURNAMES = """
    Chai Cheong Chew Chiang Chin Chong Choo Chow Chui Chung Fong Fung Gan Goh
    Gwee Han Ho Hong Hoon Hu Kang Kee Khoo Koh Kuek Kwan Kwek Lai Lam Lau Law
    Lee Leow Lew Liew Lim Lin Lo Loke Lye Mok Ng Ong Ooi Pang Peh Phang Poh Poon
    Qiu See Seow Seet Shen Sng Song Soon Sun Tan Tang Tay Teng Thia Ting Tong
    Tung Wee Woo Wu Xie Yan Yang Yee Yip Yong Yu Yuen Zheng Zhou Zhu
""".split()

# Syllables of given names, joined by two.
CHINESE_SYLLABLES = """
    Ai An Bao Bee Bin Boon Cai Chee Cheng Chin Choon Chun Dan Eng En Fang Fei
    Feng Geok Guo Han Hao Heng Hock Hong Hua Huey Hui Hwa Jia Jian Jie Jing Jun
    Kai Keat Keng Kim Kiat Kok Lan Lay Lee Lei Leng Li Lian Lin Ling Mei Meng
    Min Mui Ngee Peck Peng Ping Poh Qi Qian Qing Rui Rong Seng Shan Shi Shu Siew
    Sin Soo Suan Swee Ting Tong Wah Wai Wei Wen Xia Xiang Xiao Xin Xiu Xuan Xue
    Yan Yang Yee Yi Ying Yong Yoke Yu Yuan Yue Yun Ze Zhen Zhi Zi
""".split()

ENGLISH_GIVEN = """
    Aaron Agnes Albert Alex Alfred Alice Alvin Amy Andy Angeline Anna Anthony
    Arthur Ben Beatrice Benedict Betty Bryan Carol Caroline Cecilia Chris Clement
    Cindy Colin Darryl Derek Dexter Donna Doris Douglas Edward Elizabeth Emily
    Emma Ernest Florence Francis Frank Fred George Gloria Harry Helen Howard
    Hannah Hugh Ian Ivy Jack James Jane Janet Jasmine Jeff Jenny Jeremy Jerry Jill
    Joan Joel John Joyce Judy Julia Julian Justin Kate Keith Ken Kevin Larry Laura
    Leslie Linda Lisa Louis Lucy Luke Malcolm Marie Mark Martin Mary Maurice
    Max Mavis Michael Mildred Nancy Nathan Neil Nigel Norman Oliver Oscar Paul
    Pauline Philip Ralph Robert Robin Roger Ronald Rose Roy Ruby Russell Ruth
    Ryan Sally Sam Sandra Sarah Scott Sean Sharon Sheila Sophie Susan Terry
    Thomas Tina Tony Tracy Vera Violet Walter Wendy Winnie Winston Zachary Zoe
""".split()

ENGLISH_SURNAMES = """
    Adams Bailey Baker Barnes Bell Brooks Brown Carter Chapman Cole Cook Cooper
    Cox Davis Dixon Evans Ferguson Fisher Foster Gibson Green Griffin Hall Harris
    Henderson Hill Holmes Hunter Jackson Johnson Kelly Knight Lewis Lloyd Marshall
    Mason Miller Moore Murphy Nelson Newman Owen Pearce Porter Powell Price Reid
    Richards Rogers Ross Russell Scott Simpson Smith Spencer Stone Taylor Ward
    Webb White Wilson Wood Young DeSouza Fernandez Gomez DeSilva Lazaroo Minjoot
    Nonis Shepherdson
""".split()

MALAY_GIVEN = """
    Adam Adnan Aidil Aisha Ali Amin Amir Aminah Anwar Arif Asmah Azhar Aziz
    Azizah Badrul Dahlia Danial Fairuz Farid Fatimah Fauzi Fazlina Halim Halimah
    Hamzah Haris Haziq Idris Irfan Jamilah Johari Juliana Kamal Kamariah Latifah
    Maimunah Malik Mariam Masturah Murni Mustafa Nadia Nasir Nazri Nora Normah
    Rafidah Rahim Rahmat Raihan Ramlah Razak Rizal Rohani Rosli Roslan Sabariah
    Safiah Saiful Salim Salmah Sapiah Shafiq Suhaimi Syahirah Taufik Yasmin Yusri
    Zahra Zainab Zaki Zaleha Zubaidah Zulkifli
""".split()

MALAY_FATHERS = """
    Aziz Ali Hashim Haron Hussein Idris Jaafar Karim Majid Mansor Mustapha Nasir
    Omar Rahmat Razali Saad Said Talib Wahab Yaakob Yunus Zakaria
""".split()

INDIAN_GIVEN = """
    Aarthi Amutha Aravind Ashok Asha Balaji Bala Chitra Dinesh Divya Durga Ganesh
    Gayathri Gunasekaran Hari Hema Indra Jaya Jayanthi Kala Kamala Kannan Karthi
    Kumar Latha Logan Mahesh Mani Mala Meera Murali Muthu Nalini Naresh Nithya
    Pradeep Prema Priya Radha Raj Rajan Raju Rani Rekha Sarala Saroja Sathish Selvi
    Siva Sri Sudha Sunil Suman Sunita Tamil Usha Vani Vasudevan Vimala Vinod Yogesh
""".split()

INDIAN_FATHERS = """
    Alagappan Annamalai Balasubramaniam Doraisamy Gopalan Jayaraman Kandasamy
    Karuppiah Kuppusamy Maniam Murugan Naidu Narayanan Pakirisamy Periasamy
    Raghavan Raman Sannasi Shanmugam Sundaram Suppiah Velu Vellu
""".split()

INDIAN_SURNAMES = """
    Das Desai Dutta Ghosh Iyengar Jain Kapoor Khan Kumar Malhotra Mehta Mukherjee
    Patel Raman Shah Sinha Thomas Varma
""".split()


def chinese(draw):
    surname = draw.one_of(CHINESE_SURNAMES)
    given = draw.one_of(CHINESE_SYLLABLES) + " " + draw.one_of(
        CHINESE_SYLLABLES)
    english = draw.one_of(ENGLISH_GIVEN)
    return draw.one_of([f"{surname} {given}", f"{surname} {given}",
                        f"{english} {surname}",
                        f"{english} {surname} {given}"])


def malay(draw):
    link = draw.one_of(["bin", "binte"])
    return f"{draw.one_of(MALAY_GIVEN)} {link} {draw.one_of(MALAY_FATHERS)}"


def indian(draw):
    given = draw.one_of(INDIAN_GIVEN)
    link = draw.one_of(["s/o", "d/o"])
    return draw.one_of([f"{given} {link} {draw.one_of(INDIAN_FATHERS)}",
                        f"{given} {draw.one_of(INDIAN_SURNAMES)}"])


def english(draw):
    return f"{draw.one_of(ENGLISH_GIVEN)} {draw.one_of(ENGLISH_SURNAMES)}"


# Roughly the shares of the city's communities.
COMMUNITIES = [chinese] * 13 + [malay] * 3 + [indian] * 3 + [english]


def name(draw):
    return draw.one_of(COMMUNITIES)(draw)
