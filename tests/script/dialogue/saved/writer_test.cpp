#include "script/dialogue/agenda/output_queue.hpp"
#include "script/dialogue/saved/reader.hpp"
#include "script/dialogue/saved/writer.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

TEST(Writer, BeginsWithTheVersionAndTheInterpreter) {
  const auto program = small_program();
  const auto state = script::Interpreter(program).save({});
  const auto bytes = bytes_of(program, Output());
  EXPECT_EQ(bytes[0], char{conversation_version});
  EXPECT_EQ(static_cast<std::size_t>(bytes[1]), state.size());
  EXPECT_EQ(bytes.substr(2, state.size()), state);
}

TEST(Writer, APartWithoutContentsIsAByteAField) {
  const auto program = small_program();
  const auto state = script::Interpreter(program).save({});
  EXPECT_EQ(bytes_of(program, Output()).size(), 2 + state.size() + 9);
}

} // namespace
} // namespace parlour::dialogue
