#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tools/bench/speech/speech_bench.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(SpeechBenchRows, are_known) {
  EXPECT_THAT(speech_bench_rows(), Contains("names"));
  EXPECT_THAT(speech_bench_rows(), Contains("babble-10"));
}

struct SpeechBench : testing::Test {
  SpeechBench() : places(process_places()) {
    places.working = test::source_path("");
  }
  bool call(SpeechBenchOptions options) {
    options.voices = {"en-us"};
    return speech_bench(places, options, {out, err});
  }

  Places places;
  std::ostringstream out;
  std::ostringstream err;
};

TEST_F(SpeechBench, says_that_it_has_no_recordings) {
  SpeechBenchOptions options;
  options.only = "digits";
  options.recogniser = "SphinxASR";
  EXPECT_TRUE(call(options)) << out.str() << err.str();
  EXPECT_THAT(out.str(), HasSubstr("recogniser SphinxASR, not told"));
  EXPECT_THAT(out.str(), HasSubstr("not measured: --data names no folder"));
}

TEST_F(SpeechBench, names_a_recogniser_that_is_none) {
  SpeechBenchOptions options;
  options.only = "detector";
  options.recogniser = "Nobody";
  EXPECT_FALSE(call(options));
}

} // namespace
} // namespace parlour::tools
