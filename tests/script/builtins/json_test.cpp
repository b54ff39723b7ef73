#include <gtest/gtest.h>

#include "tests/script/rows.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinsJson, Writes) {
  test::expect_rows({
      {"tojson({'b': [1, unknown, true], 'a': 2.5})",
       "{\"b\":[1,null,true],\"a\":2.5}"},
      {"tojson('a\"\\n\\\\é')", "\"a\\\"\\n\\\\é\""},
      {"tojson('\\u{1}')", "\"\\u0001\""},
      {"tojson([])", "[]"},
      {"tojson(1e300)", "1e+300"},
  });
}

TEST(BuiltinsJson, Reads) {
  test::expect_rows({
      {"fromjson(' [1, -2.5e1, true, null, \"x\"] ')",
       "[1, -25, true, unknown, x]"},
      {"fromjson('{\"b\": {}, \"a\": []}')", "{b: {}, a: []}"},
      {"fromjson('\"\\\\u00e9\\\\ud83d\\\\ude00\"')", "é😀"},
      {"type(fromjson('12'))", "integer"},
      {"fromjson(tojson({'k': [1, {'l': 'm'}]}))", "{k: [1, {l: m}]}"},
      {"fromjson('[1,]')", "Type: fromjson: the text is not JSON, "
                           "from position 3"},
      {"fromjson('[\"éé\", x]')", "Type: fromjson: the text is not JSON, "
                                  "from position 7"},
      {"fromjson('')", "Type: fromjson: the text is not JSON, "
                       "from position 0"},
      {"fromjson([])",
       "Type: fromjson: argument 1 must be a string, not a list"},
  });
}

} // namespace

} // namespace parlour::script
