#include <iostream>

#include "runtime/text/json_text.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/parlour/command_fixture.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, understand_prints_the_words_the_way_and_the_acts) {
  EXPECT_EQ(call({"understand", "bicycles",
                  "I would like to rent a tandem for three days"}),
            exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("tokens i would like"));
  EXPECT_THAT(out_.str(), HasSubstr("Kind: {value: tandem,"));
  EXPECT_THAT(out_.str(), HasSubstr("Days: {value: 3,"));
  EXPECT_EQ(err_.str(), "");
}

TEST_F(CommandTest, understand_says_what_it_did_not_understand) {
  EXPECT_EQ(call({"understand", "bicycles", "zxqv"}), exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("not understood: NoResult\nscore 0\n"));
}

// A command that reads std::cin, which gets these lines.
class BatchTest : public CommandTest {
protected:
  explicit BatchTest() : before_(std::cin.rdbuf(in_.rdbuf())) {}
  ~BatchTest() override {
    std::cin.rdbuf(before_);
  }

  std::istringstream in_;
  std::streambuf* before_;
};

TEST_F(BatchTest, understand_reads_a_sentence_a_line) {
  in_.str("a tandem\nzxqv\n");
  EXPECT_EQ(call({"understand", "bicycles", "--batch"}), exit_code::success);
  std::istringstream lines(out_.str());
  std::string first, second, more;
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_FALSE(std::getline(lines, more));
  EXPECT_EQ((*read_json(first))["acts"].at(0)["slots"]["Kind"]["value"].text(),
            "tandem");
  EXPECT_EQ(second, R"({"text":"zxqv","sent":"zxqv","acts":[],"score":0.0})");
}

TEST_F(BatchTest, understand_takes_what_was_asked) {
  in_.str("3\n");
  EXPECT_EQ(call({"understand", "bicycles", "--batch", "--context",
                  R"({"asked": {"topic": "Rent", "slot": "Days"}})"}),
            exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr(R"("Days":{"value":3)"));
  EXPECT_EQ(call({"understand", "bicycles", "3", "--context", "[1"}),
            exit_code::usage);
  EXPECT_THAT(err_.str(), HasSubstr("--context is a JSON object"));
}

TEST_F(CommandTest, understand_compares_with_marked_sentences) {
  const test::TemporaryFolder folder;
  folder.write("marked.jsonl",
               "{\"text\": \"rent a tandem for three days\", \"topic\": "
               "\"Rent\", \"slots\": {\"Kind\": \"tandem\", \"Days\": 3}}\n"
               "{\"text\": \"zxqv\"}\n");
  folder.write("wrong.jsonl", "moo\n");
  const auto path = folder.path().string();
  EXPECT_EQ(call({"understand", "bicycles", "--score", path + "/marked.jsonl"}),
            exit_code::success);
  EXPECT_THAT(out_.str(), HasSubstr("frames    100.0 % (2 of 2); always"));
  EXPECT_EQ(call({"understand", "bicycles", "--score", path + "/wrong.jsonl"}),
            exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("wrong.jsonl:1: "));
  EXPECT_EQ(call({"understand", "bicycles", "--score", path + "/none.jsonl"}),
            exit_code::wrong);
  EXPECT_EQ(call({"understand", "bicycles", "--score", path}),
            exit_code::wrong);
  EXPECT_THAT(err_.str(), HasSubstr("this is a folder"));
  EXPECT_EQ(call({"understand", "bicycles", "moo", "--batch"}),
            exit_code::usage);
}

TEST_F(CommandTest, understand_wants_the_components_that_understand) {
  EXPECT_EQ(call({"understand", "greeter", "hello"}), exit_code::wrong);
  EXPECT_EQ(err_.str(), "error: greeter has no GrammarNLU to ask\n");
}

} // namespace
} // namespace parlour::tools
