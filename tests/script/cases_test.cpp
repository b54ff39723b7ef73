// Runs the language cases below cases/: small scripts whose comments say what
// to expect (margin.hpp). There is a folder for each section of the language.
#include <gtest/gtest.h>

#include "tests/script/margin.hpp"

namespace parlour::script {

namespace {

class LanguageCase : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(LanguageCase, DoesWhatItsMarginSays) {
  test::expect_as_in_margin(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Language, LanguageCase,
                         testing::ValuesIn(test::language_cases()),
                         [](const auto& one) {
                           return test::name_of_case(one.param);
                         });

} // namespace

} // namespace parlour::script
