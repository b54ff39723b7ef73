#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/base/value.hpp"

namespace parlour {
namespace {

constexpr auto largest = std::numeric_limits<std::int64_t>::max();
constexpr auto smallest = std::numeric_limits<std::int64_t>::min();

ResultSet coffee_shops() {
  return {{"name", "level"}, {"Starbucks Coffee", 1, "Ya Kun Toastwich", 2}};
}

TEST(Value, KnowsItsType) {
  EXPECT_EQ(Value().type(), ValueType::unknown);
  EXPECT_EQ(Value(true).type(), ValueType::boolean);
  EXPECT_EQ(Value(1).type(), ValueType::integer);
  EXPECT_EQ(Value(1.0).type(), ValueType::number);
  EXPECT_EQ(Value("a").type(), ValueType::string);
  EXPECT_EQ(Value(List{}).type(), ValueType::list);
  EXPECT_EQ(Value(Map{}).type(), ValueType::map);
  EXPECT_EQ(Value(ResultSet{}).type(), ValueType::result);
  EXPECT_EQ(Value(Binary{}).type(), ValueType::binary);
}

TEST(Value, NamesItsTypes) {
  EXPECT_EQ(name_of(ValueType::unknown), "unknown");
  EXPECT_EQ(name_of(ValueType::string), "string");
  EXPECT_EQ(name_of(ValueType::binary), "binary");
}

TEST(Value, IsNullWhereItIsOfAnotherType) {
  Value text("5");
  EXPECT_EQ(text.if_integer(), nullptr);
  EXPECT_EQ(text.if_boolean(), nullptr);
  EXPECT_EQ(text.if_number(), nullptr);
  EXPECT_EQ(text.if_list(), nullptr);
  EXPECT_EQ(text.if_map(), nullptr);
  EXPECT_EQ(text.if_result(), nullptr);
  EXPECT_EQ(text.if_binary(), nullptr);
  EXPECT_EQ(Value(5).if_string(), nullptr);
}

TEST(Value, TruthOfLanguageRule2) {
  for (const auto& value :
       {Value(), Value(false), Value(0), Value(0.0), Value(-0.0), Value(""),
        Value(List{}), Value(Map{}), Value(ResultSet{{"name"}, {}})})
    EXPECT_FALSE(value) << to_string(value);
  for (const auto& value :
       {Value(true), Value(-1), Value(0.1), Value("0"), Value("false"),
        Value(List{Value()}), Value(Map{{"", Value()}}), Value(coffee_shops()),
        Value(Binary{})})
    EXPECT_TRUE(value) << to_string(value);
}

TEST(Value, PrintedAsLanguageRule2Says) {
  EXPECT_EQ(to_string(Value()), "unknown");
  EXPECT_EQ(to_string(Value(true)), "true");
  EXPECT_EQ(to_string(Value(false)), "false");
  EXPECT_EQ(to_string(Value(smallest)), "-9223372036854775808");
  EXPECT_EQ(to_string(Value(0.5)), "0.5");
  EXPECT_EQ(to_string(Value(2.0)), "2");
  EXPECT_EQ(to_string(Value(-0.0)), "0");
  EXPECT_EQ(to_string(Value(0.1 + 0.2)), "0.30000000000000004");
  EXPECT_EQ(to_string(Value("it's")), "it's");
  EXPECT_EQ(to_string(Value(List{1, "a", 2.5})), "[1, a, 2.5]");
  EXPECT_EQ(to_string(Value(Map{{"k", 1}, {"m", List{2}}})), "{k: 1, m: [2]}");
  EXPECT_EQ(to_string(Value(List{})), "[]");
  EXPECT_EQ(to_string(Value(Map{})), "{}");
  EXPECT_EQ(to_string(Value(ResultSet{{"a", "b"}, {1, 2, 3, 4}})),
            "[1, 2, 3, 4]");
  EXPECT_EQ(to_string(Value(Binary{"pcm", std::vector<std::byte>(3)})),
            "binary(3)");
}

TEST(Value, PrintsEveryElementOfAListThatBeginsEmpty) {
  EXPECT_EQ(to_string(Value(List{"", "x"})), "[, x]");
  EXPECT_EQ(to_string(Value(List{"", "", ""})), "[, , ]");
  EXPECT_EQ(to_string(Value(Map{{"", ""}, {"k", 1}})), "{: , k: 1}");
}

TEST(Value, TextIsTheStringOrWhatIsPrinted) {
  EXPECT_EQ(Value("David").text(), "David");
  EXPECT_EQ(Value(12).text(), "12");
  EXPECT_EQ(Value().text(), "unknown");
}

TEST(Value, ReadsEntriesAndElementsOrUnknown) {
  Value frame(Map{{"Host", "Dr. Jeffery Ho"}, {"ids", List{4, 5}}});
  EXPECT_EQ(frame["Host"], Value("Dr. Jeffery Ho"));
  EXPECT_EQ(frame["ids"].at(1), Value(5));
  EXPECT_TRUE(frame["ids"].at(2).is_unknown());
  EXPECT_TRUE(frame["host"].is_unknown());
  EXPECT_TRUE(Value(3)["Host"].is_unknown());
  EXPECT_TRUE(frame.at(0).is_unknown());
}

TEST(Value, SharesATextWithOthers) {
  const auto text = std::make_shared<const std::string>("Wei Ling");
  const Value one(text);
  const Value other(text);
  EXPECT_EQ(one, Value("Wei Ling"));
  EXPECT_EQ(one.if_string(), other.if_string());
}

TEST(Columns, AreSharedByCopies) {
  const Columns columns{"name", "level"};
  const auto copy = columns; // NOLINT(performance-unnecessary-copy-*)
  EXPECT_EQ(copy.begin(), columns.begin());
  EXPECT_EQ(copy[1], "level");
  EXPECT_EQ(copy, (Columns{"name", "level"}));
  EXPECT_NE(copy, Columns{"name"});
}

TEST(Columns, MayBeNone) {
  for (const auto& none : {Columns(), Columns(std::vector<std::string>{})}) {
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(none.size(), 0u);
    EXPECT_EQ(none.begin(), none.end());
  }
}

TEST(Value, ConvertsNumbersForReaders) {
  EXPECT_EQ(Value(3).number_or(9), 3.0);
  EXPECT_EQ(Value(2.5).number_or(9), 2.5);
  EXPECT_EQ(Value("3").number_or(9), 9.0);
  EXPECT_EQ(Value(2.9).integer_or(9), 2);
  EXPECT_EQ(Value(-2.9).integer_or(9), -2);
  EXPECT_EQ(Value(1e300).integer_or(9), 9);
  EXPECT_EQ(Value(std::nan("")).integer_or(9), 9);
  EXPECT_EQ(Value(true).integer_or(9), 9);
}

TEST(Equality, OfNumbersIsExact) {
  EXPECT_EQ(Value(2), Value(2.0));
  EXPECT_NE(Value(2), Value(2.5));
  EXPECT_NE(Value(largest), Value(9223372036854775808.0));
  EXPECT_EQ(Value(smallest), Value(-9223372036854775808.0));
  EXPECT_NE(Value(std::int64_t{9007199254740993}), Value(9007199254740992.0));
  EXPECT_NE(Value(0), Value(std::nan("")));
  EXPECT_NE(Value(largest), Value(std::numeric_limits<double>::infinity()));
}

TEST(Equality, OfStringAndNumberGoesByWellFormedNumbers) {
  EXPECT_EQ(Value("10"), Value(10));
  EXPECT_EQ(Value(10), Value(" 1e1 "));
  EXPECT_EQ(Value("+2.50"), Value(2.5));
  EXPECT_NE(Value("10 am"), Value(10));
  EXPECT_NE(Value(""), Value(0));
  EXPECT_NE(Value("10"), Value("10.0"));
}

TEST(Equality, NeverMixesOtherTypes) {
  EXPECT_EQ(Value(), Value());
  EXPECT_NE(Value(), Value(false));
  EXPECT_NE(Value(true), Value(1));
  EXPECT_NE(Value("true"), Value(true));
  EXPECT_NE(Value(""), Value());
  EXPECT_NE(Value(List{}), Value(Map{}));
}

TEST(Equality, OfContentForListsMapsResultsAndBinaries) {
  EXPECT_EQ(Value(List{1, "a"}), Value(List{1.0, "a"}));
  EXPECT_NE(Value(List{1}), Value(List{1, 1}));
  EXPECT_EQ(Value(Map{{"a", 1}, {"b", 2}}), Value(Map{{"b", 2}, {"a", 1}}));
  EXPECT_NE(Value(Map{{"a", 1}}), Value(Map{{"b", 1}}));
  EXPECT_NE(Value(Map{{"a", 1}}), Value(Map{{"a", 1}, {"b", 2}}));
  EXPECT_EQ(Value(coffee_shops()), Value(coffee_shops()));
  EXPECT_NE(Value(coffee_shops()), Value(ResultSet{{"name", "level"}, {}}));
  EXPECT_NE(Value(Binary{"a", {}}), Value(Binary{"b", {}}));
}

TEST(Map, KeepsTheOrderOfInsertion) {
  Map map{{"b", 1}, {"a", 2}};
  map.set("c", 3);
  map.set("b", 4);
  EXPECT_EQ(to_string(Value(map)), "{b: 4, a: 2, c: 3}");
  map.erase("a");
  map.erase("missing");
  EXPECT_EQ(to_string(Value(map)), "{b: 4, c: 3}");
  EXPECT_EQ(map.size(), 2u);
  EXPECT_EQ(map.find("a"), nullptr);
}

TEST(Map, LastOfEqualKeysHolds) {
  Map map{{"a", 1}, {"a", 2}};
  EXPECT_EQ(map.size(), 1u);
  EXPECT_EQ(*map.find("a"), Value(2));
}

TEST(Map, FindsEveryKeyOfALargeOne) {
  Map map;
  for (int i = 0; i < 1000; ++i)
    map.set("k" + std::to_string(i), i);
  for (int i = 0; i < 1000; i += 2)
    map.set("k" + std::to_string(i), -i);
  for (int i = 3; i < 1000; i += 3)
    map.erase("k" + std::to_string(i));
  const Map copy = map;
  map.set("k3", "back");
  EXPECT_EQ(copy.size(), 667u);
  for (int i = 0; i < 1000; ++i) {
    const auto* found = copy.find("k" + std::to_string(i));
    if (i > 0 && i % 3 == 0)
      EXPECT_EQ(found, nullptr) << i;
    else
      EXPECT_EQ(*found, Value(i % 2 ? i : -i)) << i;
  }
  EXPECT_EQ(map.entries().back().first, "k3");
}

TEST(Map, ForgetsItsIndexWhenItIsSmallAgain) {
  Map map;
  for (int i = 0; i < 20; ++i)
    map.set(std::to_string(i), i);
  for (int i = 0; i < 19; ++i)
    map.erase(std::to_string(i));
  EXPECT_EQ(*map.find("19"), Value(19));
  EXPECT_EQ(map.find("1"), nullptr);
  const Map taken = std::move(map);
  EXPECT_EQ(taken.size(), 1u);
}

TEST(ResultSet, FindsCellsByRowAndColumn) {
  auto rows = coffee_shops();
  EXPECT_EQ(rows.row_count(), 2u);
  ASSERT_TRUE(rows.cell(1, "LEVEL"));
  EXPECT_EQ(*rows.cell(1, "LEVEL"), Value(2));
  EXPECT_EQ(rows.cell(2, "level"), nullptr);
  EXPECT_EQ(rows.cell(0, "levels"), nullptr);
  EXPECT_EQ(ResultSet{}.row_count(), 0u);
  EXPECT_EQ(ResultSet{}.cell(0, ""), nullptr);
}

TEST(NumberText, ReadsBack) {
  for (double number : {0.1, 1e21, -2.5e-8, 123456789.125, 5e-324})
    EXPECT_EQ(parse_number(number_text(number)).number_or(0), number);
  EXPECT_EQ(number_text(100), "100");
}

TEST(ParseNumber, TakesWellFormedNumbers) {
  EXPECT_TRUE(parse_number("42").if_integer());
  EXPECT_EQ(parse_number("\t-7\n"), Value(-7));
  EXPECT_EQ(parse_number("+7"), Value(7));
  EXPECT_EQ(parse_number("007"), Value(7));
  EXPECT_EQ(parse_number("2.50"), Value(2.5));
  EXPECT_EQ(parse_number("1E+3"), Value(1000));
  EXPECT_TRUE(parse_number("9223372036854775807").if_integer());
  EXPECT_TRUE(parse_number("9223372036854775808").if_number());
}

TEST(ParseNumber, RefusesTheRest) {
  for (auto text : {"", " ", "-", "+-1", "--1", ".5", "5.", "1e", "1e+", "0x10",
                    "1 2", "inf", "nan", "1,5", "1e999", "10am"})
    EXPECT_TRUE(parse_number(text).is_unknown()) << text;
}

} // namespace
} // namespace parlour
