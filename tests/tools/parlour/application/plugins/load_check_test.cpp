#include "tests/tools/parlour/application_fixture.hpp"

namespace parlour::tools {

namespace {

using testing::HasSubstr;
using testing::Not;

class LoadCheck : public ApplicationTest {
protected:
  std::string said_of(const std::string& load) const {
    return findings(this->load("<Plugins><Plugin>GrammarNLU</Plugin></Plugins>",
                               "<function name='f'>" + load + "</function>"));
  }
};

} // namespace

TEST_F(LoadCheck, refuses_a_name_that_is_not_free) {
  EXPECT_THAT(said_of("<load plugin='LogTelephone' name='ASR'/>"),
              HasSubstr("own.xml:1:64: error: 'ASR' is the name of a role"));
  EXPECT_THAT(said_of("<load plugin='LogTelephone' name='System'/>"),
              HasSubstr("error: 'System' is a source of the platform's own"));
}

TEST_F(LoadCheck, refuses_another_role_s_place) {
  EXPECT_THAT(said_of("<load plugin='LogTelephone' name='GrammarNLU'/>"),
              HasSubstr("own.xml:1:64: error: GrammarNLU: it is the NLU here, "
                        "which LogTelephone is not"));
}

TEST_F(LoadCheck, warns_of_a_plug_in_that_is_not_here) {
  EXPECT_THAT(said_of("<load plugin='LogTelephon' name='Phone'/>"),
              HasSubstr("warning: there is no plug-in 'LogTelephon', did you "
                        "mean 'LogTelephone'?"));
}

TEST_F(LoadCheck, leaves_what_may_be_right) {
  for (const auto* load : {"<load plugin='LogTelephone'/>",
                           "<load plugin='KeywordNLU' name='GrammarNLU'/>",
                           "<load plugin='{1}' name='GrammarNLU'/>",
                           "<load plugin='Elsewhere' name='GrammarNLU'/>"})
    EXPECT_THAT(said_of(load), Not(HasSubstr("error"))) << load;
}

} // namespace parlour::tools
