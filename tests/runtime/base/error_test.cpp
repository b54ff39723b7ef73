#include <set>
#include <string>

#include <gtest/gtest.h>

#include "runtime/base/error.hpp"

namespace parlour {
namespace {

Expected<int> halved(int number) {
  if (number % 2 != 0)
    return fail(ErrorKind::type, "an odd number", {"main.xml", 4, 2});
  return number / 2;
}

TEST(Error, TravelsInsteadOfAValue) {
  EXPECT_EQ(halved(4).value(), 2);
  auto odd = halved(3);
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error(),
            (Error{ErrorKind::type, "an odd number", {"main.xml", 4, 2}}));
}

TEST(Error, NamesItsPlaceAsFarAsItIsKnown) {
  auto error = halved(3).error();
  EXPECT_EQ(to_string(error), "main.xml:4: an odd number");
  error.place.line = 0;
  EXPECT_EQ(to_string(error), "main.xml: an odd number");
  error.place.file.clear();
  EXPECT_EQ(to_string(error), "an odd number");
}

TEST(ErrorKind, HasTheNamesThatScriptsCatch) {
  EXPECT_EQ(name_of(ErrorKind::type), "Type");
  EXPECT_EQ(name_of(ErrorKind::in_doubt), "InDoubt");
  EXPECT_EQ(name_of(ErrorKind::settings), "Settings");
}

TEST(ErrorKind, NamesAreDistinct) {
  std::set<std::string_view> names;
  std::size_t count = 0;
#define X(name, text, sentence)                                                \
  names.insert(name_of(ErrorKind::name));                                      \
  EXPECT_EQ(name_of(ErrorKind::name), text);                                   \
  ++count;
  PARLOUR_ERROR_KINDS(X)
#undef X
  EXPECT_EQ(names.size(), count);
}

} // namespace
} // namespace parlour
